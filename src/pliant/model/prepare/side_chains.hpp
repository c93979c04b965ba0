// SPDX-License-Identifier: MIT
// Builds missing side chains by rule: ideal lengths and angles, and those usual torsions that
// overlap least with other atoms. This is a guess: no data showed these atoms.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pliant/model/prepare/edit_structure.hpp"
#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

/// A side chain with built atoms.
struct BuiltSideChain {
  std::uint32_t residue;
  std::string atoms;  ///< "CG CD OE1 OE2"
  /// largest overlap, Angstrom below the least distance of two atoms; 0: none
  double overlap = 0.0;
};

/// A structure whose side chains are complete where that was possible.
struct BuiltSideChains {
  EditedStructure edited;
  std::vector<BuiltSideChain> built;
  std::vector<std::uint32_t> left;  ///< residues that lack N, CA or C, or an atom between others
};

/// Builds the missing side-chain atoms of the twenty amino acids and keeps existing atoms. Residues
/// choose their torsions one after another, then once more with all others in place. Deterministic;
/// linear in the number of atoms.
BuiltSideChains build_side_chains(const Structure& structure);

}  // namespace pliant
