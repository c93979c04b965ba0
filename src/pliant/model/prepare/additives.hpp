// SPDX-License-Identifier: MIT
// Which molecules of a structure are there for the crystal's sake: see crystal_additives.hpp.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

/// Residues, ascending.
struct Additives {
  std::vector<std::uint32_t> out;        ///< that a model leaves out
  std::vector<std::uint32_t> at_metals;  ///< that stay, since N, O or S of theirs is at a metal
};

/// The additives of a structure whose bonds are known; none where it has no amino acid and no
/// nucleotide. What is bonded to anything else is no additive. `keep` names residues that are none
/// either; "all": none is. Linear in the number of atoms. Throws OptionError for a name that is not
/// in the table.
Additives find_additives(const Structure& structure, const std::vector<std::string>& keep);

/// "8 DMS, 5 GOL", the most frequent first.
std::string counted_names(const AtomTable& atoms, const std::vector<std::uint32_t>& residues);

}  // namespace pliant
