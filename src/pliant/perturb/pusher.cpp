// SPDX-License-Identifier: MIT
#include "pliant/perturb/pusher.hpp"

#include <cmath>
#include <string>

#include "pliant/base/error.hpp"
#include "pliant/base/number.hpp"
#include "pliant/perturb/past.hpp"

namespace pliant {
namespace {

/// 1 kJ/(mol Angstrom) / 1 u in Angstrom/ps^2.
constexpr double acceleration_of_unit_force = 100.0;

void require(bool ok, const char* name, double value, const char* range) {
  if (!ok) throw OptionError(std::string(name) + " = " + number_text(value) + ": must be " + range);
}

/// What a joint does by its velocity, if it has not been moved in this step.
Vec3 glide(const PushCall& call, Joint joint, const State& state) {
  const Vec3 x = state.positions[joint], start = state.previous[joint];
  return (1.0 - call.damping) * (x == start ? x - call.older[joint] : Vec3{});
}

/// By how much a unit of force moves a joint, Angstrom.
double gain(const PushCall& call, Joint joint) {
  const double dt = call.timestep;
  return acceleration_of_unit_force * call.framework.inverse_masses()[joint] * dt * dt;
}

}  // namespace

void move_by_verlet(const PushCall& call, const JointForce& push, State& state) {
  if (call.framework.is_pinned(push.joint)) return;
  const Vec3 x = state.positions[push.joint];
  Vec3 next = x + glide(call, push.joint, state) + gain(call, push.joint) * push.force;
  if (call.framework.is_planar()) next.z = x.z;
  state.positions[push.joint] = next;
}

JointForce held_back(const PushCall& call, const JointForce& push, const State& state,
                     double longest) {
  if (call.framework.is_pinned(push.joint)) return push;
  const Vec3 by_itself = glide(call, push.joint, state);
  const double unit = gain(call, push.joint);
  Vec3 moved = by_itself + unit * push.force;
  if (call.framework.is_planar()) moved.z = 0.0;
  const double length = norm(moved);
  if (length <= longest) return push;
  return {push.joint, (1.0 / unit) * ((longest / length) * moved - by_itself)};
}

void move_by_verlet(const PushCall& call, std::span<const JointForce> forces, State& state,
                    Push& out) {
  for (const JointForce& push : forces) {
    move_by_verlet(call, push, state);
    out.add(push.joint, push.force);
    out.forces.push_back(push);
  }
}

Push apply_forces(const Framework& framework, const PerturbOptions& options,
                  std::span<const JointForce> forces, State& state) {
  Past past;
  past.begin_step(state);
  Push push;
  move_by_verlet({framework, {}, options.timestep, options.damping, past.older()}, forces, state,
                 push);
  return push;
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
