// SPDX-License-Identifier: MIT
// Bodies that hang on each other, in eight walkers at once: what a step in torsion space does to
// all of them. The counterpart of ArticulatedPass and ArticulatedStep (resolve/froda), with the
// same bits in each lane.
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

/// The bodies and what a step keeps of them. During a step only gather() and go_inward() change it.
struct LaneForest {
  LaneList<LaneBody> bodies;
  std::size_t turn_count;
  double damping, square_unit;  ///< Angstrom^2
  LaneInertia* inertia;         ///< of bodies
  LaneTurn* turns;
  const LaneSpring* springs;  ///< of turns
};

/// How bodies and turns move, or what pulls on them: values of bodies, then of turns.
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

  /// The sum over bodies and turns of forces times moves.
  LaneValue (*product)(const LaneForest& forest, LaneMoves forces, LaneMoves moves);
  /// ArticulatedStep::apply_matrix, but for its rows.
  LaneValue (*apply_matrix)(const LaneForest& forest, const LaneVector* x, LaneMoves direction,
                            LaneTwist* image);
  /// forces -= step times what turns resist by themselves times their angles.
  void (*resist)(const LaneForest& forest, const LaneValue& step, const LaneValue* angles,
                 LaneValue* forces);

  /// y += factor x.
  void (*add_scaled)(const LaneValue& factor, const LaneValue* x, std::size_t count, LaneValue* y);
  /// y = x + factor y.
  void (*add_to_scaled)(const LaneValue* x, const LaneValue& factor, std::size_t count,
                        LaneValue* y);
  /// y = x in those lanes.
  void (*copy)(LaneMask lanes, const LaneValue* x, std::size_t count, LaneValue* y);

  /// ArticulatedStep::share_of: how much of the step is taken.
  LaneValue (*share_of)(const LaneForest& forest, const LaneVector* x, LaneMoves moves,
                        const LaneValue& bound, double largest_turn);
  /// ArticulatedStep::move; `room` is of bodies.
  void (*move)(const LaneForest& forest, LaneMoves moves, const LaneValue& share, LaneMotion* room,
               LaneVector* x);
};

}  // namespace pliant
