// SPDX-License-Identifier: MIT
// Bonds of the CONECT records of a PDB file.
#pragma once

#include <cstdint>
#include <vector>

#include "pliant/molecule/read/pdb/pdb_serials.hpp"
#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

/// Serial numbers that CONECT records refer to.
struct ConectTargets {
  const SerialIndex& atoms;
  const std::vector<std::int64_t>& ter_serials;  ///< sorted; TER records have serials, too
  bool hexadecimal = false;
};

/// The bonds of CONECT records, between atoms by the index in `targets`; sorted, each once. A
/// partner given twice in one direction makes a double bond. If a file has such a bond, its other
/// bonds are single; otherwise their order is unknown. Fields outside their columns are read as
/// separated by blanks if all are serials of atoms. Invalid references (unknown, repeated or
/// overflowed serials, an atom with itself) are left out with a warning.
std::vector<Bond> conect_bonds(const std::vector<PdbLine>& records, const ConectTargets& targets,
                               Remarks& remarks);

}  // namespace pliant
