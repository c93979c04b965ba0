// SPDX-License-Identifier: MIT
// SSBOND and LINK records of PDB files.
#pragma once

#include <vector>

#include "pliant/molecule/read/pdb/pdb_columns.hpp"
#include "pliant/molecule/read/shared/stated_links.hpp"

namespace pliant {

/// The links that SSBOND and LINK records state. A residue number that is none is warned of, and
/// the record left out.
std::vector<StatedLink> pdb_links(const std::vector<PdbLine>& records, Remarks& remarks);

}  // namespace pliant
