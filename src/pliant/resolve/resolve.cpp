// SPDX-License-Identifier: MIT
#include "pliant/resolve/resolve.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "pliant/base/error.hpp"
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

}  // namespace

/// The resolver's inside: the plan (ordering with shares) and the loop over sweeps.
class Resolver::Sweeps {
 public:
  Sweeps(const Framework& framework, const Technique& technique, const ResolveOptions& options)
      : framework_(framework),
        technique_(technique),
        options_(options),
        entry_(find_ordering(technique.name)) {}

  ResolveSummary resolve(std::span<Vec3> positions, Joint root, std::int64_t step) {
    const auto start = std::chrono::steady_clock::now();
    before_.assign(positions.begin(), positions.end());
    key_ = {options_.seed, Domain::order, options_.walker, static_cast<std::uint64_t>(step), 0};
    ResolveSummary summary;
    summary.sweeps = summary.projections = 0;
    summary.stop = sweep_until_whole(positions, root, summary);
    finish(positions, summary);
    summary.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return summary;
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
    entry_.order({framework_, root, sweep, key_, positions, sweep > 0 ? &last_ordering_ : nullptr},
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

  void finish(std::span<Vec3> positions, ResolveSummary& summary) {
    ResidualSummary residuals = measure(framework_, positions, options_.tolerance);
    if (!residuals.finite) {
      summary.stop = Stop::not_finite;
      summary.worst_bar = residuals.worst_bar;
      std::copy(before_.begin(), before_.end(), positions.begin());
      residuals = measure(framework_, positions, options_.tolerance);
    } else {
      summary.worst_bar = residuals.worst_bar;
    }
    summary.max_residual = residuals.max_relative;
    summary.rms_residual = residuals.rms_relative;
  }

  const Framework& framework_;
  Technique technique_;
  ResolveOptions options_;
  const OrderingEntry& entry_;
  RandomKey key_;
  Ordering ordering_, last_ordering_;
  OrderScratch scratch_;
  std::vector<PlannedBar> plan_;
  std::vector<Vec3> before_;
  std::size_t hint_ = 0;
  bool planned_ = false;
  Joint planned_root_ = 0;
};

Resolver::Resolver(const Framework& framework, const Technique& technique,
                   const ResolveOptions& options) {
  check(options);
  check(technique, framework);
  sweeps_ = std::make_unique<Sweeps>(framework, technique, options);
  joint_count_ = framework.joint_count();
}

Resolver::~Resolver() = default;
Resolver::Resolver(Resolver&&) noexcept = default;

ResolveSummary Resolver::resolve(std::span<Vec3> positions, Joint root, std::int64_t step) {
  if (positions.size() != joint_count_)
    throw OptionError("positions: " + std::to_string(positions.size()) + " for " +
                      std::to_string(joint_count_) + " joints");
  if (root >= joint_count_ && joint_count_ > 0)
    throw OptionError("root joint " + std::to_string(root) + " of " + std::to_string(joint_count_) +
                      " does not exist");
  return sweeps_->resolve(positions, root, step);
}

void check(const ResolveOptions& options) {
  const auto positive = [](const char* name, double value) {
    if (!(value > 0.0 && std::isfinite(value)))
      throw OptionError(std::string(name) + " = " + std::to_string(value) +
                        ": must be positive and finite");
  };
  positive("tolerance", options.tolerance.relative);
  if (options.tolerance.length != 0.0) positive("tolerance_length", options.tolerance.length);
  if (options.max_sweeps < 1)
    throw OptionError("max_sweeps = " + std::to_string(options.max_sweeps) + ": must be from 1");
}

std::string ResolveSummary::brief(const Framework& framework) const {
  std::string text = std::string(name(stop)) + ": " + std::to_string(sweeps) + " sweeps, " +
                     std::to_string(projections) + " projections";
  if (framework.bar_count() == 0) return text;
  char number[32];
  std::snprintf(number, sizeof number, "%.2g", max_residual);
  return text + ", worst bar " + framework.label(framework.bars()[worst_bar]) + " off by " +
         number + " of its length";
}

ResolveSummary resolve(const Framework& framework, const Technique& technique,
                       std::span<Vec3> positions, const ResolveOptions& options, Joint root) {
  return Resolver(framework, technique, options).resolve(positions, root);
}

}  // namespace pliant
