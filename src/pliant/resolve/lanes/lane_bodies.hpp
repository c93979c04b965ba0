// SPDX-License-Identifier: MIT
// Operations of a step in torsion space on connected bodies in eight walkers at once. They do what
// ArticulatedPass and ArticulatedStep (resolve/froda) do, with the same bits in each lane.
#pragma once

#include <cstddef>
#include <cstdint>

#include "pliant/resolve/lanes/lane_kernels.hpp"

namespace pliant {

/// A rigid unit, as PlanBody has it.
struct LaneBody {
  std::int32_t parent;  ///< comes before; -1: moves freely
  std::uint32_t first, last, a, b, first_turn, turns;
};

struct LaneTwist {
  LaneValue of[6];
};
struct LaneInertia {
  LaneValue of[21];
};
/// As ArticulatedPass::Turn.
struct LaneTurn {
  LaneTwist s, u;
  LaneValue inverse, force;
};
/// As TurnSpring.
struct LaneSpring {
  LaneValue weight, force;
};
/// Rows of a rotation, and a shift (Angstrom).
struct LaneMotion {
  LaneVector rx, ry, rz, shift;
};

/// The bodies and what a step stores for them. During a step only gather() and go_inward() change
/// it.
struct LaneForest {
  LaneList<LaneBody> bodies;
  std::size_t turn_count;
  double damping, square_unit;  ///< Angstrom^2
  LaneInertia* inertia;         ///< of bodies
  LaneTurn* turns;
  const LaneSpring* springs;  ///< of turns
};

/// Motions of bodies and turns, or forces on them: values of bodies, then of turns.
struct LaneMoves {
  LaneTwist* twists;
  LaneValue* angles;
};

struct LaneBodyKernels {
  /// ArticulatedPass::gather; lanes without targets have forces of 0.
  void (*gather)(const LaneForest& forest, const LaneVector* x, const LaneVector* targets,
                 LaneMask has_targets, LaneTwist* forces);
  void (*go_inward)(const LaneForest& forest, LaneTwist* forces);
  void (*push_inward)(const LaneForest& forest, LaneMoves forces);
  void (*go_outward)(const LaneForest& forest, const LaneTwist* forces, LaneMoves out);

  /// The scalar product of forces and moves over bodies and turns.
  LaneValue (*product)(const LaneForest& forest, LaneMoves forces, LaneMoves moves);
  /// ArticulatedStep::apply_matrix without its rows.
  LaneValue (*apply_matrix)(const LaneForest& forest, const LaneVector* x, LaneMoves direction,
                            LaneTwist* image);
  /// forces -= step times the turns' own resistance times their angles.
  void (*resist)(const LaneForest& forest, const LaneValue& step, const LaneValue* angles,
                 LaneValue* forces);

  /// y += factor x.
  void (*add_scaled)(const LaneValue& factor, const LaneValue* x, std::size_t count, LaneValue* y);
  /// y = x + factor y.
  void (*add_to_scaled)(const LaneValue* x, const LaneValue& factor, std::size_t count,
                        LaneValue* y);
  /// y = x in these lanes.
  void (*copy)(LaneMask lanes, const LaneValue* x, std::size_t count, LaneValue* y);

  /// ArticulatedStep::share_of: the share of the step that is taken.
  LaneValue (*share_of)(const LaneForest& forest, const LaneVector* x, LaneMoves moves,
                        const LaneValue& bound, double largest_turn);
  /// ArticulatedStep::move; `room` has an entry for each body.
  void (*move)(const LaneForest& forest, LaneMoves moves, const LaneValue& share, LaneMotion* room,
               LaneVector* x);
};

}  // namespace pliant
