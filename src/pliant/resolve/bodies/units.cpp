// SPDX-License-Identifier: MIT
#include "pliant/resolve/bodies/units.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "pliant/resolve/blocks/blocks.hpp"
#include "pliant/resolve/bodies/outward/unit_pass.hpp"
#include "pliant/resolve/bodies/pull/froda_solver.hpp"

namespace pliant {
namespace {

/// How many times further than bars are off joints may move before a pass looks ahead.
constexpr double most_growth = 8.0;

/// Units of three or more joints; without any there is nothing to gain.
bool has_more_than_rods(const UnitSet& set) { return set.things().size() > 2 * set.size(); }

class Units final : public Method {
 public:
  Units(const Framework& framework, const Technique& technique, const ResolveOptions& options)
      : framework_(framework), technique_(technique), options_(options) {
    if (framework.is_planar()) return;  // units would turn out of the plane
    UnitSet units = find_units(framework);
    if (has_more_than_rods(units))
      pass_ = std::make_unique<UnitPass>(framework, std::move(units), technique, options);
  }

  Stop resolve(const ResolveCall& call, ResolveSummary& summary) override {
    if (!pass_) return leave_to_blocks(call, summary);
    if (is_whole(call.positions)) return Stop::converged;
    before_.assign(call.positions.begin(), call.positions.end());
    const UnitPass::Placement placement = pass_->run(call);
    if (placement == UnitPass::Placement::not_finite) return Stop::not_finite;
    ++summary.sweeps;
    summary.projections += static_cast<std::int64_t>(framework_.bar_count());
    if (is_whole(call.positions)) {
      if (has_swung(call)) follow_from_reference(call, summary);
      if (has_swung(call)) look_ahead(call, summary);
      if (has_swung(call)) return_to_reference(call);
      return Stop::converged;
    }
    if (summary.sweeps >= options_.max_sweeps) return Stop::max_sweeps;
    if (options_.should_stop && options_.should_stop()) return Stop::stopped_by_caller;
    if (!(largest_error(call.positions) < largest_error(before_)))
      std::copy(before_.begin(), before_.end(), call.positions.begin());
    return leave_to_blocks(call, summary);
  }

 private:
  /// Whether some joint ended much further from where it was than any bar was from whole: errors
  /// grew from unit to unit. Where bars were as far off as that, one of the first tells so.
  bool has_swung(const ResolveCall& call) const {
    const double enough = farthest(call.positions) / most_growth;
    for (const Incidence& at : framework_.neighbours(call.disturbed.root))
      if (error(before_, at.bar) >= enough) return false;
    for (std::size_t k = 0; k < framework_.bar_count(); ++k)
      if (error(before_, k) >= enough) return false;
    return true;
  }

  double farthest(std::span<const Vec3> positions) const {
    double most = 0.0;
    for (std::size_t k = 0; k < before_.size(); ++k)
      most = std::max(most, norm_squared(positions[k] - before_[k]));
    return std::sqrt(most);
  }

  /// The pass again, looking ahead; what the first gave is kept if that is nearer.
  void look_ahead(const ResolveCall& call, ResolveSummary& summary) {
    after_.assign(call.positions.begin(), call.positions.end());
    const UnitPass::Placement outcome = pass_->look_ahead(call, before_);
    summary.projections += static_cast<std::int64_t>(framework_.bar_count());
    if (outcome != UnitPass::Placement::placed || !is_whole(call.positions) ||
        farthest(call.positions) > farthest(after_))
      std::copy(after_.begin(), after_.end(), call.positions.begin());
  }

  /// From the positions before the push, if they are known, all units turn about their hinges to
  /// where it has left them, as in `froda`; what the pass gave is kept if that is nearer.
  void follow_from_reference(const ResolveCall& call, ResolveSummary& summary) {
    if (call.reference.empty() || !is_whole(call.reference)) return;
    if (!has_planned_) froda_ = plan_froda(framework_);
    has_planned_ = true;
    if (!froda_) return;
    after_.assign(call.positions.begin(), call.positions.end());
    const int steps = froda_->solver.resolve(call.reference, before_, call.positions).steps;
    summary.projections += steps * static_cast<std::int64_t>(framework_.bar_count());
    if (!is_whole(call.positions) || farthest(call.positions) > farthest(after_))
      std::copy(after_.begin(), after_.end(), call.positions.begin());
  }

  /// A chain that is all stretched out cannot follow its joints: it stays where it was whole.
  void return_to_reference(const ResolveCall& call) const {
    if (call.reference.empty() || framework_.has_pinned_joints()) return;
    if (farthest(call.reference) < farthest(call.positions) && is_whole(call.reference))
      std::copy(call.reference.begin(), call.reference.end(), call.positions.begin());
  }

  double error(std::span<const Vec3> positions, std::size_t bar) const {
    const Bar ends = framework_.bars()[bar];
    return std::abs(residual(positions[ends.a], positions[ends.b], framework_.rest_lengths()[bar]));
  }

  bool is_whole(std::span<const Vec3> positions) const {
    return pliant::is_whole(framework_, positions, options_.tolerance);
  }

  /// The largest error in units of what is allowed; infinite if a length is no number.
  double largest_error(std::span<const Vec3> positions) const {
    double largest = 0.0;
    for (std::size_t k = 0; k < framework_.bar_count(); ++k) {
      const double here = error(positions, k) / options_.tolerance.of(framework_.rest_lengths()[k]);
      if (!(here <= largest)) largest = std::isnan(here) ? HUGE_VAL : here;
    }
    return largest;
  }

  Stop leave_to_blocks(const ResolveCall& call, ResolveSummary& summary) {
    if (!blocks_) blocks_ = make_blocks(framework_, technique_, options_);
    return blocks_->resolve(call, summary);
  }

  const Framework& framework_;
  Technique technique_;
  ResolveOptions options_;
  std::unique_ptr<UnitPass> pass_;  ///< null: rods alone
  std::unique_ptr<Method> blocks_;
  bool has_planned_ = false;
  std::unique_ptr<PlannedFroda> froda_;  ///< null: not planned yet, or there is no plan
  std::vector<Vec3> before_, after_;     ///< to keep what was better, and to come near it again
};

}  // namespace

std::unique_ptr<Method> make_units(const Framework& framework, const Technique& technique,
                                   const ResolveOptions& options) {
  return std::make_unique<Units>(framework, technique, options);
}

}  // namespace pliant
