// SPDX-License-Identifier: MIT
#include "pliant/resolve/lanes/lane_sweeps.hpp"

#include "pliant/resolve/method/plan_of_root.hpp"
#include "pliant/resolve/sweeps/sweep_plan.hpp"

namespace pliant {
namespace {

class LaneSweeps final : public LaneMethod {
 public:
  explicit LaneSweeps(const LaneSetting& setting)
      : framework_(setting.framework),
        technique_(setting.technique),
        options_(setting.options),
        kernels_(setting.kernels),
        entry_(find_ordering(setting.technique.name)) {}

  LaneEnds begin(const LaneCall& call) override {
    planned_.prepare(call.root, [this](Joint root) { plan(root); });
    sweeps_ = 0;
    hint_ = 0;
    return look(call, call.lanes);
  }

  LaneEnds go_on(const LaneCall& call, LaneMask left) override {
    if (sweeps_ == options_.max_sweeps) return {.max_sweeps = left};
    if (sweeps_ > 0 && options_.should_stop && options_.should_stop()) return {.stopped = left};
    return look(call, sweep(call, left));
  }

 private:
  LaneList<LaneVisit> visits() const { return {visits_.data(), visits_.size()}; }

  void plan(Joint root) {
    entry_.order({framework_, root, 0, {}, {}, nullptr, technique_.ordering.get()}, scratch_,
                 ordering_);
    visits_.clear();
    for (const OrderedBar& visit : ordering_) {
      const PlannedBar bar = planned(framework_, technique_, options_.tolerance, visit);
      visits_.push_back({bar.near, bar.far, bar.rest, bar.allowed, bar.near_share, bar.far_share});
    }
  }

  LaneEnds look(const LaneCall& call, LaneMask among) {
    LaneMask not_finite = 0;
    const LaneMask within = kernels_.look(visits(), call.positions, among, hint_, not_finite);
    const auto whole = LaneMask(within & ~not_finite);  // an infinite error may be allowed
    return {.whole = whole, .left = LaneMask(among & ~(whole | not_finite))};
  }

  /// The lanes in which no joints were in one place.
  LaneMask sweep(const LaneCall& call, LaneMask left) {
    const bool backwards = entry_.repeat == Repeat::reverse && sweeps_ % 2 == 1;
    const LaneMask coincident = kernels_.sweep(visits(), backwards, call.positions);
    left = LaneMask(left & ~coincident);
    ++sweeps_;
    call.each(left, [&](ResolveSummary& summary, std::size_t) {
      ++summary.sweeps;
      summary.projections += static_cast<std::int64_t>(visits_.size());
    });
    return left;
  }

  const Framework& framework_;
  Technique technique_;
  ResolveOptions options_;
  const LaneKernels& kernels_;
  const OrderingEntry& entry_;
  OrderScratch scratch_;
  Ordering ordering_;
  std::vector<LaneVisit> visits_;
  std::int64_t sweeps_ = 0;  ///< of this resolve
  std::size_t hint_ = 0;     ///< where its last look ended
  PlanOfRoot planned_;
};

}  // namespace

std::unique_ptr<LaneMethod> make_lane_sweeps(const LaneSetting& setting) {
  if (find_ordering(setting.technique.name).repeat == Repeat::reorder) return nullptr;
  return std::make_unique<LaneSweeps>(setting);
}

}  // namespace pliant
