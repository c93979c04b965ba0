// SPDX-License-Identifier: MIT
// Draws forms of flexible loops (large rings, macrocycles). Random torsions leave a loop open;
// Gauss-Newton steps (Levenberg, Marquardt) over its torsions then close it, turn torsions towards
// usual ones and remove overlaps; Newton steps close it to rounding. Only torsions turn: lengths,
// angles and handedness remain exact.
#pragma once

#include <span>
#include <utility>

#include "pliant/base/random.hpp"
#include "pliant/conformers/torsions/loop_plan.hpp"
#include "pliant/conformers/torsions/torsion_draws.hpp"

namespace pliant {

class LoopDraws {
 public:
  /// `plan` must outlive it.
  LoopDraws(const BodyPlan& plan, LoopPlan loops) : plan_(plan), loops_(std::move(loops)) {}

  const LoopPlan& loops() const { return loops_; }

  /// Gives the loops of `x` (N, Angstrom) another form, and moves what hangs on them. Does not
  /// change `x` if no draw can be closed.
  void draw(RandomSequence& draws, TorsionDraw how, std::span<Vec3> x) const;

 private:
  const BodyPlan& plan_;
  LoopPlan loops_;
};

}  // namespace pliant
