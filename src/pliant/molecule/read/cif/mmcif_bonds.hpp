// SPDX-License-Identifier: MIT
// Bonds in mmCIF files: struct_conn between residues, chem_comp_bond inside them.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "pliant/molecule/read/cif/cif_document.hpp"
#include "pliant/molecule/read/shared/stated_links.hpp"

namespace pliant {

/// Returns the links of a struct_conn table that are bonds: types covale, covale_..., disulf,
/// modres, and metalc, which a PDB file states by LINK and CONECT. Other types, such as hydrogen
/// bonds, are left out with one remark each. `altlocs`: as AtomSites has them.
std::vector<StatedLink> struct_conn_links(const CifDocument& document, const CifTable& table,
                                          std::span<const std::string_view> altlocs,
                                          Remarks& remarks);

/// Adds the bonds of a chem_comp_bond table to `structure.bonds`, in every residue with the
/// component's name that has both atoms.
void add_component_bonds(const CifDocument& document, const CifTable& table, Structure& structure);

}  // namespace pliant
