// SPDX-License-Identifier: MIT
// Bonds that mmCIF files state: struct_conn between residues, chem_comp_bond inside them.
#pragma once

#include <vector>

#include "pliant/molecule/read/cif/cif_document.hpp"
#include "pliant/molecule/read/shared/stated_links.hpp"

namespace pliant {

/// The links of a struct_conn table that are bonds: types covale, covale_..., disulf, modres, and
/// metalc, which a PDB file states by LINK and CONECT. Hydrogen bonds and the rest are none; each
/// type is told once.
std::vector<StatedLink> struct_conn_links(const CifDocument& document, const CifTable& table,
                                          Remarks& remarks);

/// Adds the bonds of a chem_comp_bond table to `structure.bonds`, in every residue of the
/// component's name that has both atoms.
void add_component_bonds(const CifDocument& document, const CifTable& table, Structure& structure);

}  // namespace pliant
