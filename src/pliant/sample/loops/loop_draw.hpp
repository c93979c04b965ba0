// SPDX-License-Identifier: MIT
// One draw of a loop: torsions from the usual regions of the Ramachandran plot, closed.
#pragma once

#include <span>
#include <vector>

#include "pliant/base/random.hpp"
#include "pliant/sample/loops/loop_closure.hpp"
#include "pliant/sample/loops/loop_residues.hpp"

namespace pliant {

/// phi and psi of the residues of a loop as turns against the start, of those that turn.
class LoopTurns {
 public:
  /// Residues that are linked on both sides, one after the other. Both must outlive it; `start` (N,
  /// Angstrom).
  LoopTurns(std::span<const LoopResidue> loop, std::span<const Vec3> start)
      : loop_(loop), start_(start) {}

  std::vector<LoopAxis> axes() const;
  /// Each residue is redrawn with probability `share`; the others turn only to close the loop.
  std::vector<double> draw(double share, RandomSequence& draws) const;
  /// (residues) phi and psi from -pi to pi.
  std::vector<PhiPsi> torsions(std::span<const double> turns) const;
  /// Adds the turns into the allowed regions.
  void add_wishes(std::span<const double> turns, std::span<double> wishes) const;
  bool are_allowed(std::span<const double> turns) const;
  /// Moves the joints of the loop in `x` (N) from where they are in `from` by motions of the axes.
  void move(std::span<const RigidMotion> motions, std::span<const Vec3> from,
            std::span<Vec3> x) const;

 private:
  std::span<const LoopResidue> loop_;
  std::span<const Vec3> start_;
};

/// Draws a loop, and moves its joints to `x` (N) from where they are in `from` (N), whose backbone
/// is that of `start`; all others stay. False where it does not close within the regions: then `x`
/// has not changed.
bool draw_loop(std::span<const LoopResidue> loop, std::span<const Vec3> start,
               std::span<const Vec3> from, RandomSequence& draws, std::span<Vec3> x);

}  // namespace pliant
