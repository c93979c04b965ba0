// SPDX-License-Identifier: MIT
// The residues of proteins as links of loops: which joints each torsion of the backbone moves, and
// what holds them.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "pliant/framework/framework.hpp"
#include "pliant/resolve/bodies/tree/body_plan.hpp"
#include "pliant/sample/loops/loop_torsions.hpp"

namespace pliant {

struct LoopResidue {
  std::uint32_t residue = 0;  ///< of the atom table
  Joint n = 0, ca = 0, c = 0;
  Joint before = 0, behind = 0;  ///< C and N of its neighbours, if it is linked to them
  /// Its joints: those that lie before phi along the chain, between phi and psi, behind psi.
  std::array<std::vector<Joint>, 3> parts;
  bool has_phi = false, has_psi = false;  ///< whether it turns
  bool is_linked_before = false, is_linked_behind = false;
  /// By other bonds to another residue or by a metal; or a peptide group turns.
  bool is_held = false;
  LoopResidueKind kind = LoopResidueKind::general;
  PhiPsi start;           ///< if it is linked on both sides
  double reach = 1.0;     ///< of loop_reach() that is allowed: at least that of the start
  double contacts = 0.0;  ///< so many hold it; one to another residue counts half
};

/// All that have N, CA and C, in the order of the atoms at `start` (N, Angstrom). The framework
/// must have names.
std::vector<LoopResidue> loop_residues(const Framework& framework, const BodyPlan& plan,
                                       std::span<const Vec3> start);

}  // namespace pliant
