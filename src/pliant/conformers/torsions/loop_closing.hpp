// SPDX-License-Identifier: MIT
// One new form of flexible loops: the positions of their joints, copies at the cuts included, which
// turn about hinges until the loops are closed.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "pliant/base/random.hpp"
#include "pliant/conformers/torsions/loop_equations.hpp"
#include "pliant/conformers/torsions/loop_plan.hpp"
#include "pliant/conformers/torsions/torsion_draws.hpp"

namespace pliant {

class LoopClosing {
 public:
  /// Both must outlive it. `x` (N, Angstrom) has closed loops. Atoms that cannot form a hydrogen
  /// bond are kept `reach` times their least distance apart.
  LoopClosing(const BodyPlan& plan, const LoopPlan& loops, std::span<const Vec3> x, double reach);

  /// Draws which amides are cis, equally often as trans.
  void draw_amides(RandomSequence& draws);
  /// Draws the other torsions, which opens the loops.
  void open(RandomSequence& draws, TorsionDraw how);
  /// Closes the loops approximately, without overlaps, and with usual torsions if `how` says so.
  void relax(TorsionDraw how);
  /// Closes the loops to rounding by small turns; returns false if that fails.
  bool close();
  /// How far from planar the worst of the amides that turn is (sine of its torsion).
  double twist() const;
  /// What relax() minimizes, without the gaps.
  double strain(TorsionDraw how) const;

  void write(std::span<Vec3> x) const;

 private:
  /// A torsion and its gradient with respect to its four positions.
  struct Bend {
    Turn now;
    std::array<Vec3, 4> gradient;
  };
  /// A term for a distance: its error and its weight.
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
  Turn opened(std::size_t torsion, RandomSequence& draws, TorsionDraw how) const;
  Turn off_usual(std::size_t torsion, Turn now) const;
  double weight_of(const LoopTorsion& torsion, TorsionDraw how) const;

  const BodyPlan& plan_;
  const LoopPlan& loops_;
  double reach_;
  double farthest_ = 0.0;       ///< largest distance of pairs that have a term (Angstrom)
  std::vector<Vec3> x_;         ///< (places)
  std::vector<Turn> at_start_;  ///< (torsions)
  std::vector<bool> is_cis_;    ///< (torsions) amides as drawn
  LoopEquations equations_;
};

}  // namespace pliant
