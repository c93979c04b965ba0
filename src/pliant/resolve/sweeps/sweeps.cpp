// SPDX-License-Identifier: MIT
#include "pliant/resolve/sweeps/sweeps.hpp"

#include "pliant/resolve/method/plan_of_root.hpp"
#include "pliant/resolve/sweeps/limit_sweep.hpp"
#include "pliant/resolve/sweeps/sweep_plan.hpp"

namespace pliant {
namespace {

/// The plan (ordering with shares) and the loop over sweeps.
class Sweeps final : public Method {
 public:
  Sweeps(const Framework& framework, const Technique& technique, const ResolveOptions& options)
      : framework_(framework),
        technique_(technique),
        options_(options),
        entry_(find_ordering(technique.name)),
        limits_(make_limit_sweep(framework, technique.mass_weighted, options.tolerance)) {}

  Stop resolve(const ResolveCall& call, ResolveSummary& summary) override {
    key_ = call.key;
    if (limits_) limits_->begin(call.limits_off);
    return sweep_until_whole(call.positions, call.disturbed.root, summary);
  }

 private:
  Stop sweep_until_whole(std::span<Vec3> positions, Joint root, ResolveSummary& summary) {
    prepare_first(positions, root);
    for (;;) {
      switch (look(positions)) {
        case Look::all_whole:
          return Stop::converged;
        case Look::not_finite:
          return Stop::not_finite;
        case Look::broken:
          break;
      }
      if (summary.sweeps == options_.max_sweeps) return Stop::max_sweeps;
      if (summary.sweeps > 0) {
        if (options_.should_stop && options_.should_stop()) return Stop::stopped_by_caller;
        if (entry_.repeat == Repeat::reorder) plan_sweep(positions, root, summary.sweeps);
      }
      sweep(positions, entry_.repeat == Repeat::reverse && summary.sweeps % 2 == 1);
      ++summary.sweeps;
      summary.projections += static_cast<std::int64_t>(plan_.size());
      if (limits_) summary.projections += limits_->sweep(positions, key_);
    }
  }

  void sweep(std::span<Vec3> positions, bool backwards) const {
    if (options_.on_bar) return plan_.sweep_watched(positions, key_, backwards, options_.on_bar);
    plan_.sweep(positions, key_, backwards);
  }

  Look look(std::span<const Vec3> positions) {
    const Look bars = plan_.look(positions);
    return limits_ && bars == Look::all_whole ? limits_->look(positions) : bars;
  }

  /// The plan of the last call is kept if it would come out the same.
  void prepare_first(std::span<const Vec3> positions, Joint root) {
    plan_.begin();
    if (entry_.repeat == Repeat::reorder)
      plan_sweep(positions, root, 0);
    else
      planned_.prepare(root, [&](Joint from) { plan_sweep(positions, from, 0); });
  }

  void plan_sweep(std::span<const Vec3> positions, Joint root, std::int64_t sweep) {
    std::swap(ordering_, last_ordering_);
    entry_.order({framework_, root, sweep, key_, positions, sweep > 0 ? &last_ordering_ : nullptr,
                  technique_.ordering.get()},
                 scratch_, ordering_);
    plan_.clear();
    for (const OrderedBar& visit : ordering_)
      plan_.add(planned(framework_, technique_, options_.tolerance, visit));
  }

  const Framework& framework_;
  Technique technique_;
  ResolveOptions options_;
  const OrderingEntry& entry_;
  std::unique_ptr<LimitSweep> limits_;  ///< null: there are none
  RandomKey key_;
  Ordering ordering_, last_ordering_;
  OrderScratch scratch_;
  SweepPlan plan_;
  PlanOfRoot planned_;
};

}  // namespace

std::unique_ptr<Method> make_sweeps(const Framework& framework, const Technique& technique,
                                    const ResolveOptions& options) {
  return std::make_unique<Sweeps>(framework, technique, options);
}

}  // namespace pliant
