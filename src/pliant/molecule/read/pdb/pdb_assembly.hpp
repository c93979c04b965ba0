// SPDX-License-Identifier: MIT
// Biological assemblies of a PDB file: REMARK 350.
#pragma once

#include <string>
#include <vector>

#include "pliant/molecule/read/pdb/pdb_columns.hpp"
#include "pliant/molecule/read/shared/assembly.hpp"

namespace pliant {

/// Names of the assemblies ("1", "2") in the lines of REMARK 350, in their order.
std::vector<std::string> pdb_assembly_names(const std::vector<PdbLine>& remark_350);

/// The assembly of that name. Throws InputError naming the line of an invalid or missing row of a
/// matrix.
Assembly pdb_assembly(const std::vector<PdbLine>& remark_350, const std::string& name,
                      const Remarks& remarks);

}  // namespace pliant
