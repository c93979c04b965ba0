// SPDX-License-Identifier: MIT
#include "pliant/resolve/lanes/lane_sweeps.hpp"

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

  void resolve(const LaneCall& call) override {
    if (!planned_ || planned_root_ != call.root) plan(call.root);
    LaneMask active = call.lanes;
    std::size_t hint = 0;
    for (std::int64_t sweeps = 0; leave_if_whole(call, hint, active); ++sweeps) {
      if (sweeps == options_.max_sweeps) return call.end.finish(active, Stop::max_sweeps);
      if (sweeps > 0 && options_.should_stop && options_.should_stop())
        return call.end.finish(active, Stop::stopped_by_caller);
      sweep(call, sweeps, active);
    }
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
    planned_ = true;
    planned_root_ = root;
  }

  /// Whether any lane is left to sweep.
  bool leave_if_whole(const LaneCall& call, std::size_t& hint, LaneMask& active) const {
    LaneMask not_finite = 0;
    const LaneMask within = kernels_.look(visits(), call.positions, active, hint, not_finite);
    const auto whole = LaneMask(within & ~not_finite);  // an infinite error may be allowed
    if (whole != 0) call.end.finish_whole(whole);
    active = LaneMask(active & ~(whole | not_finite));
    return active != 0;
  }

  void sweep(const LaneCall& call, std::int64_t sweeps, LaneMask& active) const {
    const bool backwards = entry_.repeat == Repeat::reverse && sweeps % 2 == 1;
    const LaneMask coincident = kernels_.sweep(visits(), backwards, call.positions);
    active = LaneMask(active & ~coincident);
    call.each(active, [&](ResolveSummary& summary, std::size_t) {
      ++summary.sweeps;
      summary.projections += static_cast<std::int64_t>(visits_.size());
    });
  }

  const Framework& framework_;
  Technique technique_;
  ResolveOptions options_;
  const LaneKernels& kernels_;
  const OrderingEntry& entry_;
  OrderScratch scratch_;
  Ordering ordering_;
  std::vector<LaneVisit> visits_;
  bool planned_ = false;
  Joint planned_root_ = 0;
};

}  // namespace

std::unique_ptr<LaneMethod> make_lane_sweeps(const LaneSetting& setting) {
  if (find_ordering(setting.technique.name).repeat == Repeat::reorder) return nullptr;
  return std::make_unique<LaneSweeps>(setting);
}

std::unique_ptr<LaneMethod> make_lane_local_sweeps(const LaneSetting& setting) {
  const Technique& asked = setting.technique;
  const Technique everywhere{"bfs_cycle", asked.weighting, asked.mass_weighted};
  return make_lane_sweeps({setting.framework, everywhere, setting.options, setting.kernels});
}

}  // namespace pliant
