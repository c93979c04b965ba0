// SPDX-License-Identifier: MIT
// SSBOND and LINK records of PDB files.
#pragma once

#include <vector>

#include "pliant/molecule/read/pdb/pdb_columns.hpp"
#include "pliant/molecule/read/shared/stated_links.hpp"

namespace pliant {

/// The links of SSBOND and LINK records. A record with an invalid residue number is left out with a
/// warning.
std::vector<StatedLink> pdb_links(const std::vector<PdbLine>& records, Remarks& remarks);

}  // namespace pliant
