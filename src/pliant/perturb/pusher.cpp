// SPDX-License-Identifier: MIT
#include "pliant/perturb/pusher.hpp"

#include <cmath>
#include <string>

#include "pliant/base/choices.hpp"
#include "pliant/base/error.hpp"
#include "pliant/base/number.hpp"
#include "pliant/perturb/guided_pushers.hpp"
#include "pliant/perturb/past.hpp"
#include "pliant/perturb/random_pushers.hpp"
#include "pliant/perturb/replay.hpp"

namespace pliant {
namespace {

/// 1 kJ/(mol Angstrom) / 1 u in Angstrom/ps^2.
constexpr double acceleration_of_unit_force = 100.0;

constexpr PusherEntry table[] = {
    {"force", "a random force on one random joint, moved by Verlet (as in the thesis)", make_force},
    {"force_all", "a random force on every joint, all moved by Verlet", make_force_all},
    {"displacement", "every joint displaced in a random direction (as in FRODA)",
     make_displacement},
    {"replay", "given forces on given joints, one per step, moved by Verlet", make_replay},
    {"rock", "given vectors there and back, such as a mode of an elastic network", make_rock},
    {"pull", "groups pulled to given places, step by step", make_pull},
    {"pair_distance", "pairs of groups brought to given distances, step by step",
     make_pair_distance},
};

void require(bool ok, const char* name, double value, const char* range) {
  if (!ok) throw OptionError(std::string(name) + " = " + number_text(value) + ": must be " + range);
}

}  // namespace

std::span<const PusherEntry> pushers() { return table; }

const PusherEntry& find_pusher(std::string_view name) { return choose(pushers(), "pusher", name); }

void move_by_verlet(const PushCall& call, const JointForce& push, State& state) {
  if (call.framework.is_pinned(push.joint)) return;
  const double dt = call.timestep;
  const Vec3 x = state.positions[push.joint], start = state.previous[push.joint];
  const Vec3 moved = x == start ? x - call.older[push.joint] : Vec3{};
  const double gain =
      acceleration_of_unit_force * call.framework.inverse_masses()[push.joint] * dt * dt;
  Vec3 next = x + (1.0 - call.damping) * moved + gain * push.force;
  if (call.framework.is_planar()) next.z = x.z;
  state.positions[push.joint] = next;
}

void move_by_verlet(const PushCall& call, std::span<const JointForce> forces, State& state,
                    Push& out) {
  for (const JointForce& push : forces) {
    move_by_verlet(call, push, state);
    out.add(push.joint, push.force);
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
