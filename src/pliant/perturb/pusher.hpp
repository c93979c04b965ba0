// SPDX-License-Identifier: MIT
// Pushers (perturbations, force fields, a hand at the mouse): what breaks the bars at the start of
// a step. Several act one after another. The table of them is in pushers.hpp.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "pliant/base/random.hpp"
#include "pliant/perturb/guide.hpp"
#include "pliant/perturb/push.hpp"

namespace pliant {

/// How hard to push. Checked once, by check().
struct PerturbOptions {
  double force = 50.0;        ///< magnitude of a random force, kJ/(mol Angstrom)
  double timestep = 0.01;     ///< ps
  double damping = 0.0;       ///< share of its velocity that a pushed joint loses a step, 0 to 1
  double displacement = 0.1;  ///< length of a random displacement, or a guided step (Angstrom)
};

/// Throws OptionError naming the option, its value and its range.
void check(const PerturbOptions& options);

/// What a pusher may use in one step.
struct PushCall {
  const Framework& framework;
  RandomKey key = {};                ///< this pusher's own: each draw adds its domain and joint
  double timestep = 0.01;            ///< ps
  double damping = 0.0;              ///< share of its velocity that a pushed joint loses a step
  std::span<const Vec3> older = {};  ///< (N) where the joints were a step before state.previous
};

/// One pusher serves one walker. It may keep a state of its own, but a restart gives the same bits
/// only if what it does follows from the call and the positions.
class Pusher {
 public:
  virtual ~Pusher() = default;
  /// Moves state.positions, never a pinned joint, and adds to `out` whom it moved. Other pushers
  /// may have acted before it in this step: state.previous (not to be changed) tells where the
  /// joints were before any did, state.step is still the last one. False: this was its last push.
  /// A step that is cut short is pushed again.
  virtual bool push(const PushCall& call, State& state, Push& out) = 0;
};

/// What the pushers of the table are made with.
struct PusherOptions {
  PerturbOptions perturb = {};
  std::vector<JointForce> replay = {};           ///< of `replay`: one force a step, or
  std::int64_t replay_from = 0;                  ///< the step after which replays and guides begin
  Guide guide = {};                              ///< of `rock`, `pull` and `pair_distance`
  std::vector<std::int64_t> replay_counts = {};  ///< of `replay`: (S) so many in each step
};

/// Moves a joint by position Verlet under a force:
///   x_new = x + (1 - damping) (x - x_old) + a dt^2,   a [Angstrom/ps^2] = 100 F / m
/// (Verlet, Phys. Rev. 159 (1967) 98; thesis appendix A). A pinned joint stays. In a planar
/// framework the z of forces and motions counts for nothing. The factor 100 turns
/// kJ/(mol Angstrom u) into Angstrom/ps^2. A joint that has left state.previous in this step goes
/// on from where it is, without its velocity: forces on one joint add up.
void move_by_verlet(const PushCall& call, const JointForce& push, State& state);

/// The same of each of these forces, and adds their joints to `out`.
void move_by_verlet(const PushCall& call, std::span<const JointForce> forces, State& state,
                    Push& out);

/// The force nearest to it by which move_by_verlet moves the joint by `longest` Angstrom at most,
/// what the joint does by its velocity included.
JointForce held_back(const PushCall& call, const JointForce& push, const State& state,
                     double longest);

/// A step of one pusher that applies these forces by move_by_verlet, with state.previous left as
/// the positions before it.
Push apply_forces(const Framework& framework, const PerturbOptions& options,
                  std::span<const JointForce> forces, State& state);

/// The forces that the pusher `force` meets in `count` steps after step key.step: each of
/// size options.force, in a random direction, on a random joint that is free to move (ForceGen).
/// Throws OptionError if every joint is pinned, or as check() does.
std::vector<JointForce> random_pushes(const Framework& framework, const PerturbOptions& options,
                                      RandomKey key, std::int64_t count);

}  // namespace pliant
