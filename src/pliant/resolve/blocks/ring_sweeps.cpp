// SPDX-License-Identifier: MIT
#include "pliant/resolve/blocks/ring_sweeps.hpp"

#include <algorithm>
#include <vector>

#include "pliant/resolve/blocks/outward_plan.hpp"
#include "pliant/resolve/blocks/sweep_group.hpp"
#include "pliant/resolve/blocks/sweep_groups.hpp"
#include "pliant/resolve/method/mass_centre.hpp"
#include "pliant/resolve/method/plan_of_root.hpp"
#include "pliant/resolve/method/project_bar.hpp"

namespace pliant {
namespace {

class RingSweeps final : public Method {
 public:
  /// `technique` is what sweeps are made with, its name an ordering. Limits and sterics tie what
  /// hangs behind a bridge to the rest: where rings are swept alone they are left aside.
  RingSweeps(const Framework& framework, const Technique& technique, const ResolveOptions& options,
             bool rings_alone, bool accelerated)
      : framework_(framework),
        technique_(technique),
        options_(options),
        entry_(find_ordering(technique.name)),
        planner_(framework),
        rings_alone_(rings_alone),
        bar_groups_(rings_alone ? group_ring_systems(framework, planner_)
                                : group_all_bars(framework)),
        limits_(rings_alone
                    ? nullptr
                    : make_limit_sweep(framework, technique.mass_weighted, options.tolerance)) {
    for (const std::vector<Joint>& joints : bar_groups_.joints)
      groups_.emplace_back(joints, accelerated);
    if (limits_) groups_.front().add(*limits_);
  }

  Stop resolve(const ResolveCall& call, ResolveSummary& summary) override {
    planned_.prepare(call.disturbed.root, [this](Joint root) { plan(root); });
    if (limits_) limits_->begin(call.limits_off);
    bridges_.begin();
    for (Look look = look_at_all(call);;) {
      if (look == Look::all_whole) return Stop::converged;
      if (look == Look::not_finite) return Stop::not_finite;
      if (summary.sweeps == options_.max_sweeps) return Stop::max_sweeps;
      if (summary.sweeps > 0 && options_.should_stop && options_.should_stop()) {
        put_together(call, summary);
        return Stop::stopped_by_caller;
      }
      look = sweep(call, summary);
    }
  }

 private:
  void plan(Joint root) {
    entry_.order({.framework = framework_, .root = root}, scratch_, ordering_);
    for (SweepGroup& group : groups_) group.clear_plan();
    bridges_.clear();
    for (const OrderedBar& visit : ordering_) {
      const PlannedBar bar = planned(framework_, technique_, options_.tolerance, visit);
      const std::uint32_t group = bar_groups_.of_bar[visit.bar];
      if (group == no_group)
        bridges_.add(bar);
      else
        groups_[group].add(bar);
    }
    if (rings_alone_) planner_.plan(root, outward_);
  }

  /// Begins with `positions` as they are.
  Look look_at_all(const ResolveCall& call) {
    Look worst = bridges_.look(call.positions);
    for (SweepGroup& group : groups_) {
      group.begin(call.positions);
      worst = std::max(worst, group.state());
    }
    return worst;
  }

  /// One sweep: every bar that is not known to be whole, once.
  Look sweep(const ResolveCall& call, ResolveSummary& summary) {
    Look worst = Look::all_whole;
    for (SweepGroup& group : groups_) {
      if (group.state() == Look::all_whole) continue;
      summary.projections += group.sweep(call.key);
      worst = std::max(worst, group.state());
    }
    ++summary.sweeps;
    const bool is_last = worst == Look::all_whole || summary.sweeps == options_.max_sweeps;
    if (worst == Look::not_finite || !is_last) return worst;
    put_together(call, summary);
    return worst == Look::all_whole ? look_at_all(call) : worst;
  }

  /// The outward pass. A group that is not carried is where it is.
  void put_together(const ResolveCall& call, ResolveSummary& summary) {
    summary.projections += static_cast<std::int64_t>(bridges_.size());
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      if (bar_groups_.is_carried[g]) continue;
      const auto joints = groups_[g].joints();
      for (std::size_t i = 0; i < joints.size(); ++i)
        call.positions[joints[i]] = groups_[g].positions()[i];
    }
    for (const OutwardStep& step : outward_) {
      if (step.block == no_block)
        project(call, step);
      else if (bar_groups_.of_block[step.block] != no_group)
        carry(call, step.near, groups_[bar_groups_.of_block[step.block]]);
    }
  }

  void project(const ResolveCall& call, const OutwardStep& step) const {
    if (bar_groups_.of_bar[step.bar] != no_group) return;
    project_bar(call.positions[step.near], call.positions[step.far],
                framework_.rest_lengths()[step.bar], 0.0, 1.0,
                [&] { return escape_direction(call.key, step.bar, framework_.is_planar()); });
  }

  /// Brings a ring system to where the joint is by which it is entered.
  static void carry(const ResolveCall& call, Joint entry, const SweepGroup& group) {
    const Vec3 by = call.positions[entry] - group.position(entry);
    const auto joints = group.joints();
    for (std::size_t i = 0; i < joints.size(); ++i)
      if (joints[i] != entry) call.positions[joints[i]] = group.positions()[i] + by;
  }

  const Framework& framework_;
  Technique technique_;
  ResolveOptions options_;
  const OrderingEntry& entry_;
  OutwardPlanner planner_;
  bool rings_alone_;
  BarGroups bar_groups_;
  std::unique_ptr<LimitSweep> limits_;  ///< null: there are none
  std::vector<SweepGroup> groups_;
  SweepPlan bridges_;
  std::vector<OutwardStep> outward_;
  Ordering ordering_;
  OrderScratch scratch_;
  PlanOfRoot planned_;
};

/// Rings first; then, if that leaves a limit or an overlap, sweeps of all bars with them.
class RingsThenLimits final : public Method {
 public:
  RingsThenLimits(const Framework& framework, const Technique& technique,
                  const ResolveOptions& options, bool accelerated)
      : rings_(std::make_unique<RingSweeps>(framework, technique, options, true, accelerated)),
        all_(framework, technique, options, false, accelerated),
        limits_(framework, technique.mass_weighted, options.tolerance) {
    // Not after the sweeps: they keep it, and a shift would break what limits tie to the rest.
    if (technique.mass_weighted) rings_ = keep_mass_centre(framework, std::move(rings_));
  }

  Stop resolve(const ResolveCall& call, ResolveSummary& summary) override {
    const Stop stop = rings_->resolve(call, summary);
    if (stop != Stop::converged) return stop;
    limits_.begin(call.limits_off);
    if (limits_.look(call.positions) == Look::all_whole) return stop;
    return all_.resolve(call, summary);
  }

 private:
  std::unique_ptr<Method> rings_;
  RingSweeps all_;
  LimitSweep limits_;
};

std::unique_ptr<Method> make_rings(const Framework& framework, const Technique& technique,
                                   const ResolveOptions& options, bool accelerated) {
  if (framework.has_bars_only())
    return std::make_unique<RingSweeps>(framework, technique, options, true, accelerated);
  return std::make_unique<RingsThenLimits>(framework, technique, options, accelerated);
}

/// What ring systems are swept with: shared half and half, or by masses.
Technique in_rings(const Technique& technique) {
  return {"bfs_cycle", 0.5, technique.mass_weighted};
}

}  // namespace

std::unique_ptr<Method> make_anderson(const Framework& framework, const Technique& technique,
                                      const ResolveOptions& options) {
  const Technique swept{"bfs_cycle", technique.weighting, technique.mass_weighted};
  return std::make_unique<RingSweeps>(framework, swept, options, false, true);
}

std::unique_ptr<Method> make_rings_first(const Framework& framework, const Technique& technique,
                                         const ResolveOptions& options) {
  return make_rings(framework, in_rings(technique), options, false);
}

std::unique_ptr<Method> make_rings_anderson(const Framework& framework, const Technique& technique,
                                            const ResolveOptions& options) {
  return make_rings(framework, in_rings(technique), options, true);
}

}  // namespace pliant
