// SPDX-License-Identifier: MIT
// Draws forms of flexible loops (large rings, macrocycles): torsions round the loop by chance,
// which leave it open, then steps of Gauss and Newton (Levenberg, Marquardt) over the torsions that
// close it, turn torsions towards usual ones and take overlaps away, and at last Newton's alone
// until it is closed to rounding. Only torsions turn: lengths, angles and handedness stay exact.
#pragma once

#include <span>
#include <utility>

#include "pliant/base/random.hpp"
#include "pliant/sample/conformers/loop_plan.hpp"
#include "pliant/sample/conformers/torsion_draws.hpp"

namespace pliant {

class LoopDraws {
 public:
  /// `plan` outlives it.
  LoopDraws(const BodyPlan& plan, LoopPlan loops) : plan_(plan), loops_(std::move(loops)) {}

  const LoopPlan& loops() const { return loops_; }

  /// Gives the loops of `x` (N, Angstrom) another form, and moves what hangs on them. Leaves `x` as
  /// it is if no draw can be closed.
  void draw(RandomSequence& draws, TorsionDraw how, std::span<Vec3> x) const;

 private:
  const BodyPlan& plan_;
  LoopPlan loops_;
};

}  // namespace pliant
