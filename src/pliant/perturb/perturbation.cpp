// SPDX-License-Identifier: MIT
#include "pliant/perturb/perturbation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "pliant/base/choices.hpp"
#include "pliant/base/error.hpp"
#include "pliant/base/number.hpp"

namespace pliant {
namespace {

/// 1 kJ/(mol Angstrom) / 1 u in Angstrom/ps^2.
constexpr double acceleration_of_unit_force = 100.0;

RandomSequence draws(const PerturbRequest& request, Domain domain, std::uint64_t joint) {
  RandomKey key = request.key;
  key.domain = domain;
  key.joint = joint;
  return RandomSequence(key);
}

Vec3 random_direction(const PerturbRequest& request, Domain domain, std::uint64_t joint) {
  return request.framework.random_direction(draws(request, domain, joint));
}

Vec3 random_force(const PerturbRequest& request, Joint joint) {
  return request.options.force * random_direction(request, Domain::force, joint);
}

/// Calls `take(joint, direction)` for all joints: random_direction() of each, some at a time.
template <class Take>
void each_direction(const PerturbRequest& request, Domain domain, Take take) {
  std::array<Vec3, 128> directions;
  const std::size_t count = request.framework.joint_count();
  RandomKey key = request.key;
  key.domain = domain;
  for (std::size_t begin = 0; begin < count; begin += directions.size()) {
    key.joint = begin;
    const std::span<Vec3> some(directions.data(), std::min(directions.size(), count - begin));
    random_directions(key, request.framework.is_planar(), some);
    for (std::size_t i = 0; i < some.size(); ++i) take(begin + i, some[i]);
  }
}

/// A joint that is free to move, each equally likely; no_joint if all are pinned.
std::int64_t random_free_joint(const PerturbRequest& request) {
  const Framework& framework = request.framework;
  if (framework.pinned_count() == framework.joint_count()) return no_joint;
  RandomSequence sequence = draws(request, Domain::root_joint, 0);
  for (;;) {
    const auto joint = static_cast<Joint>(sequence.below(framework.joint_count()));
    if (!framework.is_pinned(joint)) return joint;
  }
}

Vec3 verlet(const PerturbRequest& request, const State& state, const JointForce& push) {
  const double dt = request.options.timestep;
  const Vec3 x = state.positions[push.joint];
  const Vec3 moved = x - state.previous[push.joint];
  const double gain =
      acceleration_of_unit_force * request.framework.inverse_masses()[push.joint] * dt * dt;
  Vec3 next = x + (1.0 - request.options.damping) * moved + gain * push.force;
  if (request.framework.is_planar()) next.z = x.z;
  return next;
}

/// Sets state.previous to where the joints are.
void remember(const PerturbRequest& request, State& state) {
  if (!request.moved_before) {
    std::copy(state.positions.begin(), state.positions.end(), state.previous.begin());
    return;
  }
  for (Joint joint : *request.moved_before) state.previous[joint] = state.positions[joint];
}

/// Nothing if all joints are pinned.
std::optional<JointForce> random_push(const PerturbRequest& request) {
  const std::int64_t joint = random_free_joint(request);
  if (joint == no_joint) return std::nullopt;
  return JointForce{static_cast<Joint>(joint), random_force(request, Joint(joint))};
}

Push push_one_joint(const PerturbRequest& request, State& state) {
  const std::optional<JointForce> push = random_push(request);
  if (!push) return apply_forces(request, {}, state);
  return apply_forces(request, {&*push, 1}, state);
}

Push push_all_joints(const PerturbRequest& request, State& state) {
  std::vector<JointForce> forces(request.framework.joint_count());
  each_direction(request, Domain::force, [&](std::size_t joint, Vec3 direction) {
    forces[joint] = {static_cast<Joint>(joint), request.options.force * direction};
  });
  return apply_forces(request, forces, state);
}

/// FRODA's way: no velocities, each joint is moved by a vector of one length and random direction.
Push displace_all_joints(const PerturbRequest& request, State& state) {
  remember(request, state);
  each_direction(request, Domain::displacement, [&](std::size_t joint, Vec3 direction) {
    if (request.framework.is_pinned(static_cast<Joint>(joint))) return;
    state.positions[joint] += request.options.displacement * direction;
  });
  return {state.positions.empty() ? no_joint : 0, {}};
}

constexpr PerturbationEntry table[] = {
    {"force", "a random force on one random joint, moved by Verlet (the thesis)", push_one_joint},
    {"force_all", "a random force on every joint, all moved by Verlet", push_all_joints},
    {"displacement", "every joint displaced in a random direction (the way of FRODA)",
     displace_all_joints},
};

void require(bool ok, const char* name, double value, const char* range) {
  if (!ok) throw OptionError(std::string(name) + " = " + number_text(value) + ": must be " + range);
}

}  // namespace

std::span<const PerturbationEntry> perturbations() { return table; }

const PerturbationEntry& find_perturbation(std::string_view name) {
  return choose(perturbations(), "perturbation", name);
}

std::vector<JointForce> random_pushes(const Framework& framework, const PerturbOptions& options,
                                      RandomKey key, std::int64_t count) {
  check(options);
  std::vector<JointForce> pushes;
  for (std::int64_t k = 0; k < count; ++k) {
    ++key.step;
    const std::optional<JointForce> push = random_push({framework, options, key});
    if (!push) throw OptionError("no joint is free to be pushed: all are pinned");
    pushes.push_back(*push);
  }
  return pushes;
}

Push apply_forces(const PerturbRequest& request, std::span<const JointForce> forces, State& state) {
  std::vector<Vec3> moved;
  moved.reserve(forces.size());
  for (const JointForce& push : forces) moved.push_back(verlet(request, state, push));
  remember(request, state);
  for (std::size_t k = 0; k < forces.size(); ++k)
    if (!request.framework.is_pinned(forces[k].joint)) state.positions[forces[k].joint] = moved[k];
  if (forces.empty()) return {state.positions.empty() ? no_joint : 0, {}};
  return {forces[0].joint, forces[0].force, forces.size() == 1};
}

void check(const PerturbOptions& options) {
  const auto is_size = [](double value) { return value >= 0.0 && std::isfinite(value); };
  require(is_size(options.force), "force", options.force, "0 or more and finite");
  require(options.timestep > 0.0 && std::isfinite(options.timestep), "timestep", options.timestep,
          "positive and finite");
  require(options.damping >= 0.0 && options.damping <= 1.0, "damping", options.damping,
          "from 0 to 1");
  require(is_size(options.displacement), "displacement", options.displacement,
          "0 or more and finite");
}

}  // namespace pliant
