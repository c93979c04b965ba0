// SPDX-License-Identifier: MIT
#include "pliant/resolve/lanes/lane_direct.hpp"

#include <algorithm>

#include "pliant/resolve/equations/direct_method.hpp"
#include "pliant/resolve/equations/kept_shapes.hpp"
#include "pliant/resolve/newton/newton.hpp"

namespace pliant {
namespace {

/// The loop over components.
class LaneDirect : public LaneMethod {
 public:
  explicit LaneDirect(const LaneSetting& setting)
      : kernels_(setting.kernels),
        most_iterations_(setting.options.max_sweeps),
        components_(setting.framework, setting.options.tolerance) {
    for (const BarEquations::Part part : components_.parts())
      scratch_.fit(components_.equations().pattern(part));
  }

  bool is_entangled() const { return components_.entangled(); }
  bool any_overbraced() const {
    return std::any_of(components_.parts().begin(), components_.parts().end(),
                       BarNewton::is_overbraced);
  }

  LaneEnds go_on(const LaneCall& call, LaneMask left) override {
    for (const BarEquations::Part part : components_.parts())
      count(call, part, solve(call, components_.equations().pattern(part)), left);
    return {.converged = left};
  }

 protected:
  virtual LaneResult solve(const LaneCall& call, const BarPattern& part) = 0;

  const LaneKernels& kernels_;
  std::int64_t most_iterations_;
  ComponentEquations components_;
  LaneScratch scratch_;

 private:
  static void count(const LaneCall& call, BarEquations::Part part, const LaneResult& result,
                    LaneMask& active) {
    active = LaneMask(active & result.whole);
    call.each(active, [&](ResolveSummary& summary, std::size_t lane) {
      const auto iterations = static_cast<std::int64_t>(result.iterations[lane]);
      summary.sweeps = std::max(summary.sweeps, iterations);
      summary.projections += iterations * std::int64_t(part.bars.size());
      summary.dropped_bars += static_cast<std::int64_t>(result.dropped_bars[lane]);
      summary.off_nearest = std::max(summary.off_nearest, result.off_nearest[lane]);
    });
  }
};

class LaneShake final : public LaneDirect {
 public:
  using LaneDirect::LaneDirect;
  bool needs_reference() const override { return true; }

 private:
  LaneResult solve(const LaneCall& call, const BarPattern& part) override {
    return kernels_.shake(part, scratch_.room(), call.reference, most_iterations_, call.positions);
  }
};

class LaneNewton final : public LaneDirect {
 public:
  explicit LaneNewton(const LaneSetting& setting)
      : LaneDirect(setting), scales_(joint_scales(components_.equations())) {
    std::size_t joints = 0, bars = 0;
    for (const BarEquations::Part part : components_.parts()) {
      joints = std::max<std::size_t>(joints, part.joints.size());
      bars = std::max<std::size_t>(bars, part.bars.size());
    }
    for (auto& of_joints : of_joints_) of_joints.resize(joints);
    for (auto& of_bars : of_bars_) of_bars.resize(bars);
  }

 private:
  LaneResult solve(const LaneCall& call, const BarPattern& part) override {
    return kernels_.nearest(part, scratch_.room(), nearest_room(part), most_iterations_,
                            call.positions);
  }

  LaneNearestRoom nearest_room(const BarPattern& part) {
    auto& v = of_joints_;
    return {v[0].data(),
            v[1].data(),
            v[2].data(),
            v[3].data(),
            v[4].data(),
            v[5].data(),
            of_bars_[0].data(),
            of_bars_[1].data(),
            scales_.masses.data() + part.joints.begin,
            scales_.allowed.data() + part.joints.begin};
  }

  JointScales scales_;
  std::vector<LaneVector> of_joints_[6];
  std::vector<LaneValue> of_bars_[2];
};

bool has_shapes_to_keep(const LaneSetting& setting) {
  return !KeptShapes(setting.framework, setting.options.tolerance).empty();
}

}  // namespace

std::unique_ptr<LaneMethod> make_lane_newton(const LaneSetting& setting) {
  if (has_shapes_to_keep(setting)) return nullptr;
  auto method = std::make_unique<LaneNewton>(setting);
  if (method->is_entangled() || method->any_overbraced()) return nullptr;
  return method;
}

std::unique_ptr<LaneMethod> make_lane_shake(const LaneSetting& setting) {
  if (has_shapes_to_keep(setting)) return nullptr;
  auto method = std::make_unique<LaneShake>(setting);
  if (method->is_entangled()) return nullptr;
  return method;
}

}  // namespace pliant
