// SPDX-License-Identifier: MIT
// phi and psi of residues in loops: where they usually lie, and draws of them.
#pragma once

#include <cstdint>

#include "pliant/base/random.hpp"
#include "pliant/framework/torsion_preferences.hpp"

namespace pliant {

enum class LoopResidueKind : std::uint8_t { general, before_proline, glycine, proline };

struct PhiPsi {
  double phi = 0.0, psi = 0.0;  ///< radians
};

/// One of the peaks of the Ramachandran plot of that kind of residue in loops, and a deviation.
PhiPsi draw_phi_psi(LoopResidueKind kind, RandomSequence& draws);

/// backbone_reach(), for glycine of the plot and its mirror image.
double loop_reach(LoopResidueKind kind, PhiPsi at);

/// backbone_turn(), likewise.
BackboneTurn loop_turn(LoopResidueKind kind, PhiPsi at, double reach);

}  // namespace pliant
