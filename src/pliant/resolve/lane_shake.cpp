// SPDX-License-Identifier: MIT
#include "pliant/resolve/lane_shake.hpp"

#include <algorithm>

#include "pliant/resolve/direct_method.hpp"

namespace pliant {
namespace {

class LaneShake final : public LaneMethod {
 public:
  explicit LaneShake(const LaneSetting& setting)
      : kernels_(setting.kernels),
        most_iterations_(setting.options.max_sweeps),
        components_(setting.framework, setting.options.tolerance) {
    for (const BarEquations::Part part : components_.parts())
      scratch_.fit(components_.equations().pattern(part));
  }

  bool is_plain() const { return !components_.entangled(); }

  bool needs_reference() const override { return true; }

  void resolve(const LaneCall& call) override {
    LaneMask active = call.lanes;
    for (const BarEquations::Part part : components_.parts()) solve(call, part, active);
    if (active != 0) call.end.finish(active, Stop::converged);
  }

 private:
  void solve(const LaneCall& call, BarEquations::Part part, LaneMask& active) {
    const BarPattern pattern = components_.equations().pattern(part);
    const LaneOutcome outcome =
        kernels_.shake(pattern, scratch_.room(), call.reference, most_iterations_, call.positions);
    active = LaneMask(active & outcome.whole);
    call.each(active, [&](ResolveSummary& summary, std::size_t lane) {
      const auto iterations = static_cast<std::int64_t>(outcome.iterations[lane]);
      summary.sweeps = std::max(summary.sweeps, iterations);
      summary.projections += iterations * std::int64_t(part.bars.size());
      summary.dropped_bars += static_cast<std::int64_t>(outcome.dropped_bars[lane]);
    });
  }

  const LaneKernels& kernels_;
  std::int64_t most_iterations_;
  ComponentEquations components_;
  LaneScratch scratch_;
};

}  // namespace

std::unique_ptr<LaneMethod> make_lane_shake(const LaneSetting& setting) {
  auto method = std::make_unique<LaneShake>(setting);
  if (!method->is_plain()) return nullptr;
  return method;
}

}  // namespace pliant
