// SPDX-License-Identifier: MIT
#include "pliant/resolve/sweeps/anderson_sweeps.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

#include "pliant/resolve/method/plan_of_root.hpp"
#include "pliant/resolve/sweeps/accelerated_sweeps.hpp"

namespace pliant {
namespace {

/// The joints that sweeps may move, sorted: all, where limits or sterics may move any.
std::vector<Joint> swept_joints(const Framework& framework) {
  std::vector<Joint> joints(framework.joint_count());
  std::iota(joints.begin(), joints.end(), Joint{0});
  if (framework.has_bars_only())
    std::erase_if(joints, [&](Joint joint) { return framework.neighbours(joint).empty(); });
  return joints;
}

class AndersonSweeps final : public Method {
 public:
  AndersonSweeps(const Framework& framework, const Technique& technique,
                 const ResolveOptions& options)
      : framework_(framework),
        technique_{"bfs_cycle", technique.weighting, technique.mass_weighted},
        options_(options),
        entry_(find_ordering(technique_.name)),
        limits_(make_limit_sweep(framework, technique.mass_weighted, options.tolerance)),
        sweeps_(swept_joints(framework), limits_.get()) {}

  Stop resolve(const ResolveCall& call, ResolveSummary& summary) override {
    planned_.prepare(call.disturbed.root, [this](Joint root) { plan(root); });
    if (limits_) limits_->begin(call.limits_off);
    sweeps_.begin(call.positions);
    const Stop stop = sweep_until_whole(call, summary);
    if (stop != Stop::not_finite && summary.sweeps > 0) sweeps_.put_into(call.positions);
    return stop;
  }

 private:
  void plan(Joint root) {
    entry_.order({.framework = framework_, .root = root}, scratch_, ordering_);
    sweeps_.clear_plan();
    for (const OrderedBar& visit : ordering_)
      sweeps_.add(planned(framework_, technique_, options_.tolerance, visit));
  }

  Stop sweep_until_whole(const ResolveCall& call, ResolveSummary& summary) {
    for (;;) {
      if (sweeps_.state() == Look::all_whole) return Stop::converged;
      if (sweeps_.state() == Look::not_finite) return Stop::not_finite;
      if (summary.sweeps == options_.max_sweeps) return Stop::max_sweeps;
      if (summary.sweeps > 0 && options_.should_stop && options_.should_stop())
        return Stop::stopped_by_caller;
      summary.projections += sweeps_.sweep(call.key);
      ++summary.sweeps;
    }
  }

  const Framework& framework_;
  Technique technique_;
  ResolveOptions options_;
  const OrderingEntry& entry_;
  std::unique_ptr<LimitSweep> limits_;  ///< null: there are none
  AcceleratedSweeps sweeps_;
  Ordering ordering_;
  OrderScratch scratch_;
  PlanOfRoot planned_;
};

}  // namespace

std::unique_ptr<Method> make_anderson(const Framework& framework, const Technique& technique,
                                      const ResolveOptions& options) {
  return std::make_unique<AndersonSweeps>(framework, technique, options);
}

}  // namespace pliant
