// SPDX-License-Identifier: MIT
// Pushers (perturbations, force fields, a hand at the mouse) move joints at the start of a step,
// which breaks bars. Several act one after another. Their table is in pushers.hpp.
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
  double force = 50.0;     ///< size of a random force, kJ/(mol Angstrom)
  double timestep = 0.01;  ///< ps
  double damping = 0.0;    ///< share of its velocity that a pushed joint loses in a step, 0 to 1
  /// length of a random displacement, and most of a guided one (Angstrom)
  double displacement = 0.1;
};

/// Throws OptionError naming the option, its value and its range.
void check(const PerturbOptions& options);

/// What a pusher may use in one step.
struct PushCall {
  const Framework& framework;
  RandomKey key = {};                ///< this pusher's own; each draw adds its domain and joint
  double timestep = 0.01;            ///< ps
  double damping = 0.0;              ///< share of its velocity that a pushed joint loses in a step
  std::span<const Vec3> older = {};  ///< (N) positions one step before state.previous
};

/// A pusher serves one walker. It may have a state of its own, but a restart gives the same bits
/// only if its pushes follow from the call and the positions.
class Pusher {
 public:
  virtual ~Pusher() = default;
  /// Moves state.positions, but no pinned joint, and adds the joints that it moved to `out`.
  /// Earlier pushers of this step may have moved joints already: state.previous (not to be changed)
  /// holds the positions before all of them, and state.step is still the number of the last step.
  /// Returns false if this was its last push. A step that is cut short is pushed again.
  virtual bool push(const PushCall& call, State& state, Push& out) = 0;
};

/// What the pushers of the table are made with.
struct PusherOptions {
  PerturbOptions perturb = {};
  std::vector<JointForce> replay = {};  ///< for `replay`: forces, one a step or by replay_counts
  std::int64_t replay_from = 0;         ///< the step after which replays and guides begin
  Guide guide = {};                     ///< for `rock`, `pull` and `pair_distance`
  /// for `replay`: (S) number of forces in each step; or empty
  std::vector<std::int64_t> replay_counts = {};
};

/// Moves a joint by position Verlet under a force:
///   x_new = x + (1 - damping) (x - x_old) + a dt^2,   a [Angstrom/ps^2] = 100 F / m
/// (Verlet, Phys. Rev. 159 (1967) 98; thesis appendix A). The factor 100 turns kJ/(mol Angstrom u)
/// into Angstrom/ps^2. A pinned joint does not move. In a planar framework z of forces and motions
/// is ignored. A joint that is no longer at state.previous moves from where it is, without its
/// velocity: forces on one joint add up.
void move_by_verlet(const PushCall& call, const JointForce& push, State& state);

/// Applies each of these forces and adds their joints to `out`.
void move_by_verlet(const PushCall& call, std::span<const JointForce> forces, State& state,
                    Push& out);

/// Returns the force nearest to `push` by which move_by_verlet moves the joint by at most `longest`
/// Angstrom, its velocity included.
JointForce held_back(const PushCall& call, const JointForce& push, const State& state,
                     double longest);

/// Makes a step of one pusher that applies these forces by move_by_verlet. state.previous becomes
/// the positions before it.
Push apply_forces(const Framework& framework, const PerturbOptions& options,
                  std::span<const JointForce> forces, State& state);

/// Returns the forces that the pusher `force` applies in `count` steps after step key.step: each of
/// size options.force, in a random direction, on a random joint that can move (ForceGen). Throws
/// OptionError if every joint is pinned, or as check() does.
std::vector<JointForce> random_pushes(const Framework& framework, const PerturbOptions& options,
                                      RandomKey key, std::int64_t count);

}  // namespace pliant
