// SPDX-License-Identifier: MIT
#include "pliant/resolve/bodies/froda.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "pliant/framework/measures/kept_measure.hpp"
#include "pliant/resolve/bodies/pull/froda_solver.hpp"
#include "pliant/resolve/bodies/units.hpp"
#include "pliant/resolve/sweeps/anderson_sweeps.hpp"

namespace pliant {
namespace {

/// Bars this much better than asked for leave room for the rounding of a few steps.
constexpr double start_share = 0.1;

Tolerance for_start(Tolerance tolerance) {
  tolerance.relative *= start_share;
  tolerance.length *= start_share;
  return tolerance;
}

bool has_whole_bars(const ResidualSummary& found, const Tolerance& tolerance) {
  if (tolerance.length > 0.0) return found.max_length <= tolerance.length;
  return found.max_relative <= tolerance.relative;
}

class Froda final : public Method {
 public:
  Froda(const Framework& framework, const Technique& technique, const ResolveOptions& options)
      : framework_(framework),
        technique_(technique),
        options_(options),
        froda_(plan_froda(framework)) {}

  Stop resolve(const ResolveCall& call, ResolveSummary& summary) override {
    if (!froda_) return leave_to_sweeps(call, summary);
    look_at_reference(call);
    if (const auto stop = look_at_push(call)) return *stop;
    target_.assign(call.positions.begin(), call.positions.end());
    if (!find_start(call, summary)) return leave_to_sweeps(call, summary);
    const FrodaResult result = froda_->solver.resolve(start_, target_, call.positions,
                                                      options_of_solver(), call.limits_off);
    note(result.steps, summary);
    if (technique_.mass_weighted) keep_centre_of_mass(call.positions);
    if (measure_of(call).measure(call.positions, call.limits_off).within) return Stop::converged;
    if (summary.sweeps >= options_.max_sweeps) return Stop::max_sweeps;
    if (options_.should_stop && options_.should_stop()) return Stop::stopped_by_caller;
    return leave_to_sweeps(call, summary);
  }

 private:
  FrodaOptions options_of_solver() const {
    FrodaOptions options;
    options.limit = options_.tolerance.limit;
    options.overlap = options_.tolerance.overlap;
    options.goal = std::min({options.goal, options.limit, options.overlap});
    options.last_steps =
        static_cast<int>(std::min<std::int64_t>(options.last_steps, options_.max_sweeps));
    return options;
  }

  KeptMeasure& measure_of(const ResolveCall& call) {
    if (call.measure != nullptr) return *call.measure;
    if (!own_measure_) own_measure_ = std::make_unique<KeptMeasure>(framework_, options_.tolerance);
    return *own_measure_;
  }

  /// The reference is looked at before the push: most often it is what was measured last.
  void look_at_reference(const ResolveCall& call) {
    starts_at_reference_ = call.reference.size() == call.positions.size();
    if (!starts_at_reference_) return;
    const ResidualSummary found =
        measure_of(call).measure_bars_and_limits(call.reference, call.limits_off);
    starts_at_reference_ = found.finite && has_whole_bars(found, for_start(options_.tolerance));
  }

  /// Why there is nothing to resolve. Near joints are not looked for where a bar is broken already.
  std::optional<Stop> look_at_push(const ResolveCall& call) {
    KeptMeasure& kept = measure_of(call);
    ResidualSummary now = kept.measure_bars_and_limits(call.positions, call.limits_off);
    if (now.finite && now.within) now = kept.measure(call.positions, call.limits_off);
    if (!now.finite || !can_be_listed(call.positions)) return Stop::not_finite;
    if (now.within) return Stop::converged;
    return std::nullopt;
  }

  /// Where all bars are whole; the positions are left as they are.
  bool find_start(const ResolveCall& call, ResolveSummary& summary) {
    if (starts_at_reference_) {
      start_.assign(call.reference.begin(), call.reference.end());
      return true;
    }
    start_ = target_;
    if (!units_)
      units_ = make_units(framework_, technique_, options_with(for_start(options_.tolerance)));
    ResolveCall alone = call;
    alone.positions = start_;
    alone.disturbed = {call.disturbed.root};
    alone.moved = nullptr;
    alone.measure = nullptr;
    return units_->resolve(alone, summary) == Stop::converged &&
           is_whole(framework_, start_, options_.tolerance);
  }

  ResolveOptions options_with(const Tolerance& tolerance) const {
    ResolveOptions options = options_;
    options.tolerance = tolerance;
    return options;
  }

  /// Shifts all by as much as the centre of mass has left where the push took it.
  void keep_centre_of_mass(std::span<Vec3> positions) const {
    Vec3 off;
    double masses = 0.0;
    for (std::size_t k = 0; k < positions.size(); ++k) {
      const double mass = 1.0 / framework_.inverse_masses()[k];
      off += mass * (target_[k] - positions[k]);
      masses += mass;
    }
    for (Vec3& x : positions) x += (1.0 / masses) * off;
  }

  void note(int steps, ResolveSummary& summary) const {
    ++summary.sweeps;
    summary.projections += steps * static_cast<std::int64_t>(framework_.bar_count());
  }

  Stop leave_to_sweeps(const ResolveCall& call, ResolveSummary& summary) {
    if (!sweeps_) sweeps_ = make_anderson(framework_, technique_, options_);
    return sweeps_->resolve(call, summary);
  }

  const Framework& framework_;
  Technique technique_;
  ResolveOptions options_;
  std::unique_ptr<PlannedFroda> froda_;       ///< null: left to sweeps
  std::unique_ptr<KeptMeasure> own_measure_;  ///< of calls that bring none
  bool starts_at_reference_ = false;          ///< where bars are whole
  std::unique_ptr<Method> units_, sweeps_;
  std::vector<Vec3> start_, target_;
};

}  // namespace

std::unique_ptr<Method> make_froda(const Framework& framework, const Technique& technique,
                                   const ResolveOptions& options) {
  return std::make_unique<Froda>(framework, technique, options);
}

}  // namespace pliant
