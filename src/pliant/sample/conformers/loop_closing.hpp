// SPDX-License-Identifier: MIT
// One form of flexible loops in the making: places of their joints, copies at the cuts too, which
// turn about hinges until the loops are closed.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "pliant/base/random.hpp"
#include "pliant/sample/conformers/loop_equations.hpp"
#include "pliant/sample/conformers/loop_plan.hpp"
#include "pliant/sample/conformers/torsion_draws.hpp"

namespace pliant {

class LoopClosing {
 public:
  /// Both outlive it. `x` (N, Angstrom): loops are closed. `reach`: how many times as far as atoms
  /// must be apart they are asked to be, but those that may make a hydrogen bond.
  LoopClosing(const BodyPlan& plan, const LoopPlan& loops, std::span<const Vec3> x, double reach);

  /// Draws the torsions, which opens the loops.
  void open(RandomSequence& draws, TorsionDraw how);
  /// Closes the loops roughly, without overlaps, and with usual torsions if `how` says so.
  void relax(TorsionDraw how);
  /// Closes the loops to rounding, by small turns; false if that fails.
  bool close();
  /// What relaxing makes small, but gaps.
  double strain(TorsionDraw how) const;

  void write(std::span<Vec3> x) const;

 private:
  /// A torsion, and how it changes with each of its four places.
  struct Bend {
    Turn now;
    std::array<Vec3, 4> gradient;
  };
  /// What is asked of a distance: off by so much, and how much it counts.
  struct Wish {
    double off = 0.0, weight = 0.0;
  };

  void turn(const LoopHinge& hinge, Turn by);
  double turn_all();
  double add_gaps(double weight);
  void add_torsions(TorsionDraw how);
  void add_pairs();
  void add_pair(const LoopPair& pair, Vec3 apart, double length, Wish wish);
  Wish apart_wish(const LoopPair& pair, double length) const;
  Bend bend_of(const LoopTorsion& torsion) const;
  Turn torsion_now(const LoopTorsion& torsion) const { return bend_of(torsion).now; }
  Turn opened(const LoopTorsion& torsion, RandomSequence& draws, TorsionDraw how) const;
  Turn off_usual(std::size_t torsion, Turn now) const;
  double weight_of(const LoopTorsion& torsion, TorsionDraw how) const;

  const BodyPlan& plan_;
  const LoopPlan& loops_;
  double reach_;
  double farthest_ = 0.0;       ///< Angstrom: of pairs further apart nothing is asked
  std::vector<Vec3> x_;         ///< of places
  std::vector<Turn> at_start_;  ///< of torsions
  LoopEquations equations_;
};

}  // namespace pliant
