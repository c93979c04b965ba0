// SPDX-License-Identifier: MIT
#include "pliant/resolve/resolve.hpp"

#include <chrono>
#include <cmath>
#include <string>

#include "pliant/base/error.hpp"
#include "pliant/framework/measures/kept_measure.hpp"
#include "pliant/framework/measures/near_measure.hpp"
#include "pliant/resolve/auto.hpp"
#include "pliant/resolve/method/mass_centre.hpp"
#include "pliant/resolve/method/method.hpp"
#include "pliant/resolve/method/moved_joints.hpp"
#include "pliant/resolve/sweeps/sweeps.hpp"
#include "pliant/resolve/techniques.hpp"

namespace pliant {
namespace {

[[noreturn]] void fail_joint(const char* what, Joint joint, std::size_t joint_count) {
  throw OptionError(std::string(what) + " joint " + std::to_string(joint) + " of " +
                    std::to_string(joint_count) + " does not exist");
}

/// Sweeps of an ordering visit one bar after another in the caller's own positions.
void check_on_bar(const Framework& framework, const Technique& technique,
                  const ResolveOptions& options) {
  if (!options.on_bar) return;
  const Technique used = technique_used(framework, technique);
  if (entry_of(used).make != make_sweeps)
    throw OptionError("on_bar: technique " + used.name + " does not go bar by bar; orderings do");
}

}  // namespace

using Clock = std::chrono::steady_clock;

/// What stays between resolves: the technique's method, and the positions to go back to.
struct Resolver::MethodPlan {
  const Framework& framework;
  ResolveOptions options;
  Technique technique;
  std::unique_ptr<Method> method;
  MovedJoints moved;  ///< by the last resolve, and where they were before
  std::vector<std::uint8_t> limits_off;
  std::unique_ptr<KeptMeasure> kept;  ///< null: bars alone, or not needed yet
  NearMeasure near;
  std::optional<std::uint64_t> near_walker;  ///< what `near` knows is of this walker

  MethodPlan(const Framework& framework_, const Technique& technique_,
             const ResolveOptions& options_)
      : framework(framework_),
        options(options_),
        technique(technique_),
        near(framework, options.tolerance) {
    method = entry_of(technique).make(framework, technique, options);
    if (framework.has_bars_only() && shifts_to_mass_centre(technique_used(framework, technique)))
      method = keep_mass_centre(framework, std::move(method));
    moved.note_all({});
  }

  void prepare_near() {
    if (method->looks_near()) method->prepare_near();
  }

  /// Whether the method was given `moved` to note joints in, rather than all being noted before.
  bool begin(std::span<const Vec3> positions, const Disturbed& disturbed) {
    const bool continues = disturbed.continues && near_walker == options.walker;
    near_walker.reset();
    const bool is_near = !disturbed.all && !positions.empty() && method->looks_near();
    if (!is_near || !near.begin(positions, disturbed.joints, continues)) {
      measure_by_kept();
      moved.note_all(positions);
      return false;
    }
    moved.clear();
    moved.reserve(positions.size());
    return true;
  }

  void measure_by_kept() {
    if (!kept && !framework.has_bars_only())
      kept = std::make_unique<KeptMeasure>(framework, options.tolerance);
  }

  /// Measures what came out. Here alone positions are put back, where a number was not finite.
  void finish(std::span<Vec3> positions, const Disturbed& disturbed, ResolveSummary& summary) {
    if (!moved.holds_all())
      near.look(positions, moved.joints());
    else
      measure_by_kept();  // a near call may end as one of all
    ResidualSummary found = look(positions, disturbed);
    summary.worst_bar = found.worst_bar;
    if (!found.finite || summary.stop == Stop::not_finite) {
      summary.stop = Stop::not_finite;
      moved.put_back(positions);
      found = look(positions, disturbed);
    }
    // Never "converged" beyond the tolerance, whatever a method believes.
    if (!found.within && summary.stop == Stop::converged) summary.stop = Stop::max_sweeps;
    // Local sweeps do not look again after the last one.
    if (!moved.holds_all() && found.within && summary.stop == Stop::max_sweeps)
      summary.stop = Stop::converged;
    summary.max_residual = found.max_relative;
    summary.rms_residual = found.rms_relative;
    note_violations(found, summary);
    if (!moved.holds_all() && summary.converged()) near_walker = options.walker;
  }

  ResidualSummary look(std::span<const Vec3> positions, const Disturbed& disturbed) const {
    if (!moved.holds_all()) return measure_near(positions, disturbed);
    if (kept) return kept->measure(positions, limits_off);
    return measure(framework, positions, options.tolerance);
  }

  /// Measures the bars at joints that were disturbed or moved; rms_relative is -1.
  ResidualSummary measure_near(std::span<const Vec3> positions, const Disturbed& disturbed) const {
    ResidualSummary found;
    found.rms_relative = -1.0;
    // Of two that moved, the first measures the bar between them.
    const auto measure_at = [&](Joint joint) {
      const bool is_noted = moved.holds(joint);
      near.measure_at(positions, joint, limits_off, found,
                      [&](Joint other) { return other < joint && is_noted && moved.holds(other); });
    };
    measure_at(disturbed.root);
    for (Joint joint : disturbed.joints)
      if (joint != disturbed.root) measure_at(joint);
    for (Joint joint : moved.joints()) measure_at(joint);
    return found;
  }

  RandomKey key(std::int64_t step) const {
    return {options.seed, Domain::order, options.walker, static_cast<std::uint64_t>(step), 0};
  }
};

Resolver::Resolver(const Framework& framework, const Technique& technique,
                   const ResolveOptions& options) {
  check(options);
  check(technique, framework);
  check_on_bar(framework, technique, options);
  plan_ = std::make_unique<MethodPlan>(framework, technique, options);
}

Resolver::~Resolver() = default;
Resolver::Resolver(Resolver&&) noexcept = default;

void Resolver::set_walker(std::uint64_t walker) { plan_->options.walker = walker; }

void Resolver::set_limits_off(std::span<const std::uint8_t> off) {
  const std::size_t limit_count = plan_->framework.limits().size();
  if (!off.empty() && off.size() != limit_count)
    throw OptionError("limits_off: " + std::to_string(off.size()) + " for " +
                      std::to_string(limit_count) + " limits");
  plan_->limits_off.assign(off.begin(), off.end());
}

void Resolver::check_arguments(std::span<const Vec3> positions, const Disturbed& disturbed,
                               std::span<const Vec3> reference) const {
  const std::size_t joint_count = plan_->framework.joint_count();
  if (positions.size() != joint_count)
    throw OptionError("positions: " + std::to_string(positions.size()) + " for " +
                      std::to_string(joint_count) + " joints");
  if (!reference.empty() && reference.size() != joint_count)
    throw OptionError("reference: " + std::to_string(reference.size()) + " positions for " +
                      std::to_string(joint_count) + " joints");
  if (disturbed.root >= joint_count && joint_count > 0)
    fail_joint("root", disturbed.root, joint_count);
  for (Joint joint : disturbed.joints)
    if (joint >= joint_count) fail_joint("disturbed", joint, joint_count);
}

ResolveSummary Resolver::resolve(std::span<Vec3> positions, const Disturbed& disturbed,
                                 std::int64_t step, std::span<const Vec3> reference) {
  check_arguments(positions, disturbed, reference);
  if (!disturbed.all) plan_->prepare_near();
  const auto start = Clock::now();
  ResolveSummary summary;
  summary.sweeps = summary.projections = 0;
  summary.dropped_bars = summary.finishing_sweeps = 0;
  const bool is_near = plan_->begin(positions, disturbed);
  summary.stop = plan_->method->resolve(
      {positions, disturbed, plan_->key(step), reference, is_near ? &plan_->moved : nullptr,
       plan_->limits_off, plan_->moved.before(), plan_->kept.get(), plan_->near.neighbours()},
      summary);
  plan_->finish(positions, disturbed, summary);
  summary.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  return summary;
}

std::optional<std::span<const Joint>> Resolver::moved() const {
  if (plan_->moved.holds_all()) return std::nullopt;
  return plan_->moved.joints();
}

ResolveSummary resolve(const Framework& framework, const Technique& technique,
                       std::span<Vec3> positions, const ResolveOptions& options, Joint root) {
  return Resolver(framework, technique, options).resolve(positions, root);
}

}  // namespace pliant
