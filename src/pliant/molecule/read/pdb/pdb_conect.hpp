// SPDX-License-Identifier: MIT
// Bonds that the CONECT records of a PDB file state.
#pragma once

#include <cstdint>
#include <vector>

#include "pliant/molecule/read/pdb/pdb_serials.hpp"
#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

/// What CONECT records are looked up in.
struct ConectTargets {
  const SerialIndex& atoms;
  const std::vector<std::int64_t>& ter_serials;  ///< sorted; TER records have serials, too
  bool hexadecimal = false;
};

/// The bonds of CONECT records, between atoms by the index that `targets` gives them; sorted, each
/// once. A partner given twice in one direction makes a double bond; where a file has one such,
/// its other bonds are single, else their order is not known. Fields that are not in their columns
/// are read as separated by blanks if all are serials of atoms. What cannot be followed (unknown,
/// repeated or overflowed serials, an atom with itself) is warned of and left out.
std::vector<Bond> conect_bonds(const std::vector<PdbLine>& records, const ConectTargets& targets,
                               Remarks& remarks);

}  // namespace pliant
