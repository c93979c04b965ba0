// SPDX-License-Identifier: MIT
#include "pliant/resolve/sweeps.hpp"

#include <cmath>
#include <vector>

#include "pliant/resolve/project_bar.hpp"

namespace pliant {
namespace {

/// A visit with everything that the kernel needs beside it in memory.
struct PlannedBar {
  Joint near, far;
  double rest, near_share, far_share;
  double allowed;  ///< largest |length - rest| that counts as whole
  BarIndex bar;
};

enum class Look { all_whole, broken, not_finite };

/// The plan (ordering with shares) and the loop over sweeps.
class Sweeps final : public Method {
 public:
  Sweeps(const Framework& framework, const Technique& technique, const ResolveOptions& options)
      : framework_(framework),
        technique_(technique),
        options_(options),
        entry_(find_ordering(technique.name)) {}

  Stop resolve(const ResolveCall& call, ResolveSummary& summary) override {
    key_ = call.key;
    return sweep_until_whole(call.positions, call.root, summary);
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
    }
  }

  /// The plan of the last call is kept if it would come out the same.
  void prepare_first(std::span<const Vec3> positions, Joint root) {
    hint_ = 0;
    if (entry_.repeat != Repeat::reorder && planned_ && planned_root_ == root) return;
    plan_sweep(positions, root, 0);
    planned_ = true;
    planned_root_ = root;
  }

  void plan_sweep(std::span<const Vec3> positions, Joint root, std::int64_t sweep) {
    std::swap(ordering_, last_ordering_);
    entry_.order({framework_, root, sweep, key_, positions, sweep > 0 ? &last_ordering_ : nullptr,
                  technique_.ordering.get()},
                 scratch_, ordering_);
    plan_.clear();
    for (const OrderedBar& visit : ordering_) plan_.push_back(planned(visit));
  }

  PlannedBar planned(const OrderedBar& visit) const {
    const Bar bar = framework_.bars()[visit.bar];
    const double rest = framework_.rest_lengths()[visit.bar];
    const auto [near_share, far_share] = shares(technique_, visit, framework_);
    const Joint far = visit.near == bar.a ? bar.b : bar.a;
    return {visit.near, far, rest, near_share, far_share, options_.tolerance.of(rest), visit.bar};
  }

  void sweep(std::span<Vec3> positions, bool backwards) {
    if (backwards) {
      for (auto visit = plan_.rbegin(); visit != plan_.rend(); ++visit) project(positions, *visit);
    } else {
      for (const PlannedBar& visit : plan_) project(positions, visit);
    }
  }

  void project(std::span<Vec3> positions, const PlannedBar& visit) const {
    project_bar(positions[visit.near], positions[visit.far], visit.rest, visit.near_share,
                visit.far_share, [&] { return escape_direction(visit.bar); });
  }

  Vec3 escape_direction(BarIndex bar) const {
    RandomKey key = key_;
    key.domain = Domain::escape;
    key.joint = bar;
    return RandomSequence(key).direction();
  }

  /// Is every bar whole? Begins where the last look found a broken bar, so that as long as much is
  /// broken a look costs next to nothing.
  Look look(std::span<const Vec3> positions) {
    if (hint_ >= plan_.size()) hint_ = 0;
    const Look tail = look_at(positions, hint_, plan_.size());
    return tail == Look::all_whole ? look_at(positions, 0, hint_) : tail;
  }

  Look look_at(std::span<const Vec3> positions, std::size_t from, std::size_t to) {
    for (std::size_t k = from; k < to; ++k) {
      const PlannedBar& visit = plan_[k];
      const double error =
          std::abs(residual(positions[visit.near], positions[visit.far], visit.rest));
      if (error <= visit.allowed) continue;
      hint_ = k;
      return std::isfinite(error) ? Look::broken : Look::not_finite;
    }
    return Look::all_whole;
  }

  const Framework& framework_;
  Technique technique_;
  ResolveOptions options_;
  const OrderingEntry& entry_;
  RandomKey key_;
  Ordering ordering_, last_ordering_;
  OrderScratch scratch_;
  std::vector<PlannedBar> plan_;
  std::size_t hint_ = 0;
  bool planned_ = false;
  Joint planned_root_ = 0;
};

}  // namespace

std::unique_ptr<Method> make_sweeps(const Framework& framework, const Technique& technique,
                                    const ResolveOptions& options) {
  return std::make_unique<Sweeps>(framework, technique, options);
}

}  // namespace pliant
