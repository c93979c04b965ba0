// SPDX-License-Identifier: MIT
#include "pliant/perturb/random_pushers.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "pliant/base/error.hpp"

namespace pliant {
namespace {

RandomSequence draws(RandomKey key, Domain domain, std::uint64_t joint) {
  key.domain = domain;
  key.joint = joint;
  return RandomSequence(key);
}

Vec3 random_force(const Framework& framework, const RandomKey& key, double size, Joint joint) {
  return size * framework.random_direction(draws(key, Domain::force, joint));
}

/// Calls `take(joint, direction)` for all joints: the direction of each, some at a time.
template <class Take>
void each_direction(const PushCall& call, Domain domain, Take take) {
  std::array<Vec3, 128> directions;
  const std::size_t count = call.framework.joint_count();
  RandomKey key = call.key;
  key.domain = domain;
  for (std::size_t begin = 0; begin < count; begin += directions.size()) {
    key.joint = begin;
    const std::span<Vec3> some(directions.data(), std::min(directions.size(), count - begin));
    random_directions(key, call.framework.is_planar(), some);
    for (std::size_t i = 0; i < some.size(); ++i) take(static_cast<Joint>(begin + i), some[i]);
  }
}

/// A joint that is free to move, each equally likely; no_joint if all are pinned.
std::int64_t random_free_joint(const Framework& framework, const RandomKey& key) {
  if (framework.pinned_count() == framework.joint_count()) return no_joint;
  RandomSequence sequence = draws(key, Domain::root_joint, 0);
  for (;;) {
    const auto joint = static_cast<Joint>(sequence.below(framework.joint_count()));
    if (!framework.is_pinned(joint)) return joint;
  }
}

/// A push, or nothing if all joints are pinned.
std::optional<JointForce> random_push(const Framework& framework, const RandomKey& key,
                                      double size) {
  const std::int64_t found = random_free_joint(framework, key);
  if (found == no_joint) return std::nullopt;
  const auto joint = static_cast<Joint>(found);
  return JointForce{joint, random_force(framework, key, size, joint)};
}

std::int64_t first_joint(const State& state) { return state.positions.empty() ? no_joint : 0; }

class ForcePusher final : public Pusher {
 public:
  explicit ForcePusher(double size) : size_(size) {}

  bool push(const PushCall& call, State& state, Push& out) override {
    const std::optional<JointForce> push = random_push(call.framework, call.key, size_);
    if (push) {
      move_by_verlet(call, {&*push, 1}, state, out);
    } else {
      out.add_all(first_joint(state));
    }
    return true;
  }

 private:
  double size_;
};

class ForceAllPusher final : public Pusher {
 public:
  explicit ForceAllPusher(double size) : size_(size) {}

  bool push(const PushCall& call, State& state, Push& out) override {
    Vec3 first;
    each_direction(call, Domain::force, [&](Joint joint, Vec3 direction) {
      const Vec3 force = size_ * direction;
      if (joint == 0) first = force;
      move_by_verlet(call, {joint, force}, state);
    });
    out.add_all(first_joint(state), first);
    return true;
  }

 private:
  double size_;
};

/// FRODA's way: no velocities, each joint is moved by a vector of one length and random direction.
class DisplacementPusher final : public Pusher {
 public:
  explicit DisplacementPusher(double length) : length_(length) {}

  bool push(const PushCall& call, State& state, Push& out) override {
    each_direction(call, Domain::displacement, [&](Joint joint, Vec3 direction) {
      if (call.framework.is_pinned(joint)) return;
      state.positions[joint] += length_ * direction;
    });
    out.add_all(first_joint(state));
    return true;
  }

 private:
  double length_;
};

}  // namespace

std::unique_ptr<Pusher> make_force(const Framework&, const PusherOptions& options) {
  return std::make_unique<ForcePusher>(options.perturb.force);
}

std::unique_ptr<Pusher> make_force_all(const Framework&, const PusherOptions& options) {
  return std::make_unique<ForceAllPusher>(options.perturb.force);
}

std::unique_ptr<Pusher> make_displacement(const Framework&, const PusherOptions& options) {
  return std::make_unique<DisplacementPusher>(options.perturb.displacement);
}

std::vector<JointForce> random_pushes(const Framework& framework, const PerturbOptions& options,
                                      RandomKey key, std::int64_t count) {
  check(options);
  std::vector<JointForce> pushes;
  for (std::int64_t k = 0; k < count; ++k) {
    ++key.step;
    const std::optional<JointForce> push = random_push(framework, key, options.force);
    if (!push) throw OptionError("no joint is free to be pushed: all are pinned");
    pushes.push_back(*push);
  }
  return pushes;
}

}  // namespace pliant
