// SPDX-License-Identifier: MIT
#include "pliant/resolve/resolve.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

#include "pliant/base/error.hpp"
#include "pliant/resolve/method/method.hpp"
#include "pliant/resolve/method/moved_joints.hpp"
#include "pliant/resolve/techniques.hpp"

namespace pliant {

using Clock = std::chrono::steady_clock;

/// What stays between resolves: the technique's method, and room for the positions to go back to.
struct Resolver::Plan {
  const Framework& framework;
  ResolveOptions options;
  Technique technique;
  std::unique_ptr<Method> method;
  std::vector<Vec3> before;
  const MovedJoints* moved = nullptr;  ///< of the last resolve_near; null: any joint
  std::vector<std::uint8_t> limits_off;
  std::unique_ptr<Contacts> contacts;  ///< null: no sterics

  Plan(const Framework& framework_, const Technique& technique_, const ResolveOptions& options_)
      : framework(framework_), options(options_), technique(technique_) {
    method = find_technique(technique.name).make(framework, technique, options);
    if (framework.sterics() != nullptr) contacts = std::make_unique<Contacts>(framework);
  }

  ResidualSummary measured(std::span<const Vec3> positions) const {
    return measure(framework, positions, options.tolerance, limits_off, contacts.get());
  }

  /// Measures what came out; positions that are not finite are put back first.
  void finish(std::span<Vec3> positions, ResolveSummary& summary) const {
    ResidualSummary residuals = measured(positions);
    summary.worst_bar = residuals.worst_bar;
    if (!residuals.finite) {
      summary.stop = Stop::not_finite;
      std::copy(before.begin(), before.end(), positions.begin());
      residuals = measured(positions);
    }
    // Never "converged" beyond the tolerance, whatever a method believes.
    if (!residuals.within && summary.stop == Stop::converged) summary.stop = Stop::max_sweeps;
    summary.max_residual = residuals.max_relative;
    summary.rms_residual = residuals.rms_relative;
    note_violations(residuals, summary);
  }

  /// The same where only the joints of `moved` and the root can have changed.
  void finish_near(std::span<Vec3> positions, Joint root, Vec3 pushed,
                   ResolveSummary& summary) const {
    NearResidual near = measure_near(positions, root);
    if (!near.finite) {
      summary.stop = Stop::not_finite;
      moved->put_back(positions);
      positions[root] = pushed;
      near = measure_near(positions, root);
    }
    if (!near.within && summary.stop == Stop::converged) summary.stop = Stop::max_sweeps;
    if (near.within && summary.stop == Stop::max_sweeps) summary.stop = Stop::converged;
    summary.max_residual = near.largest;
    summary.worst_bar = near.worst_bar;
  }

  struct NearResidual {
    double largest = 0.0;  ///< |length - rest| / rest
    BarIndex worst_bar = 0;
    bool within = true, finite = true;
  };

  NearResidual measure_near(std::span<const Vec3> positions, Joint root) const {
    NearResidual near;
    measure_at(positions, root, near);
    for (Joint joint : moved->joints()) measure_at(positions, joint, near);
    return near;
  }

  void measure_at(std::span<const Vec3> positions, Joint joint, NearResidual& near) const {
    for (const Incidence& at : framework.neighbours(joint)) {
      const double rest = framework.rest_lengths()[at.bar];
      const double error = std::abs(residual(positions[joint], positions[at.joint], rest));
      if (!(error <= options.tolerance.of(rest))) near.within = false;
      if (!std::isfinite(error)) near.finite = false;
      if (error / rest > near.largest) near.largest = error / rest, near.worst_bar = at.bar;
    }
  }

  RandomKey key(std::int64_t step) const {
    return {options.seed, Domain::order, options.walker, static_cast<std::uint64_t>(step), 0};
  }
};

Resolver::Resolver(const Framework& framework, const Technique& technique,
                   const ResolveOptions& options) {
  check(options);
  check(technique, framework);
  plan_ = std::make_unique<Plan>(framework, technique, options);
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

void Resolver::check_arguments(std::span<const Vec3> positions, Joint root,
                               std::span<const Vec3> reference) const {
  const std::size_t joint_count = plan_->framework.joint_count();
  if (positions.size() != joint_count)
    throw OptionError("positions: " + std::to_string(positions.size()) + " for " +
                      std::to_string(joint_count) + " joints");
  if (!reference.empty() && reference.size() != joint_count)
    throw OptionError("reference: " + std::to_string(reference.size()) + " positions for " +
                      std::to_string(joint_count) + " joints");
  if (root >= joint_count && joint_count > 0)
    throw OptionError("root joint " + std::to_string(root) + " of " + std::to_string(joint_count) +
                      " does not exist");
}

ResolveSummary Resolver::resolve(std::span<Vec3> positions, Joint root, std::int64_t step,
                                 std::span<const Vec3> reference) {
  const auto start = Clock::now();
  check_arguments(positions, root, reference);
  plan_->moved = nullptr;
  plan_->before.assign(positions.begin(), positions.end());
  ResolveSummary summary;
  summary.sweeps = summary.projections = 0;
  summary.dropped_bars = summary.finishing_sweeps = 0;
  summary.stop = plan_->method->resolve(
      {positions, root, plan_->key(step), reference, plan_->limits_off}, summary);
  plan_->finish(positions, summary);
  summary.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  return summary;
}

ResolveSummary Resolver::resolve_near(std::span<Vec3> positions, Joint root, std::int64_t step,
                                      std::span<const Vec3> reference) {
  const auto start = Clock::now();
  // A joint that moves may touch any other: what is near by bars is not all that is disturbed.
  if (!plan_->framework.has_bars_only()) return resolve(positions, root, step, reference);
  check_arguments(positions, root, reference);
  ResolveSummary summary;
  summary.sweeps = summary.projections = summary.dropped_bars = summary.finishing_sweeps = 0;
  const Vec3 pushed = positions.empty() ? Vec3{} : positions[root];
  plan_->moved = positions.empty() ? nullptr
                                   : plan_->method->resolve_near(
                                         {positions, root, plan_->key(step), reference}, summary);
  if (plan_->moved == nullptr) return resolve(positions, root, step, reference);
  plan_->finish_near(positions, root, pushed, summary);
  summary.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  return summary;
}

ResolveSummary Resolver::resolve(std::span<Vec3> positions, const Disturbed& disturbed,
                                 std::int64_t step, std::span<const Vec3> reference) {
  if (!disturbed.all && disturbed.joints.size() == 1)
    return resolve_near(positions, disturbed.root, step, reference);
  return resolve(positions, disturbed.root, step, reference);
}

std::optional<std::span<const Joint>> Resolver::moved() const {
  if (plan_->moved == nullptr) return std::nullopt;
  return plan_->moved->joints();
}

ResolveSummary resolve(const Framework& framework, const Technique& technique,
                       std::span<Vec3> positions, const ResolveOptions& options, Joint root) {
  return Resolver(framework, technique, options).resolve(positions, root);
}

}  // namespace pliant
