// SPDX-License-Identifier: MIT
// Side chains that a structure lacks, built by rule: ideal lengths and angles, and of the usual
// torsions those that run least into other atoms. A guess: no data showed these atoms.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pliant/model/prepare/edit_structure.hpp"
#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

/// A side chain of which atoms were built.
struct BuiltSideChain {
  std::uint32_t residue;
  std::string atoms;     ///< "CG CD OE1 OE2"
  double overlap = 0.0;  ///< deepest, Angstrom below the least distance of two atoms; 0: none
};

/// A structure with its side chains complete where that could be done.
struct BuiltSideChains {
  EditedStructure edited;
  std::vector<BuiltSideChain> built;
  std::vector<std::uint32_t> left;  ///< residues that lack N, CA or C, or an atom amid others
};

/// Builds the side-chain atoms that the twenty amino acids lack; atoms that are there stay.
/// Residues choose one after the other, then once more among all. Deterministic; linear in the
/// number of atoms.
BuiltSideChains build_side_chains(const Structure& structure);

}  // namespace pliant
