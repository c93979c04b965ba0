// SPDX-License-Identifier: MIT
// The atom_site table of mmCIF.
#pragma once

#include <cstddef>
#include <string_view>

#include "pliant/molecule/read/cif/cif_document.hpp"
#include "pliant/molecule/read/shared/atom_sites.hpp"

namespace pliant {

/// "1.234(5)" is 1.234 with its standard uncertainty.
std::string_view without_uncertainty(std::string_view text);

/// Reads the atoms of the `wanted` model (counted by order of appearance from 1; none where there
/// are fewer); `model_count` becomes the number of models. Names, chains and residue numbers are
/// the author's (auth_...), as users of the literature and of other programs know them; label_...
/// where those are missing. A chain ends where label_asym_id changes. Throws InputError for missing
/// columns and for values that are not what they should be.
AtomSites read_atom_sites(const CifDocument& document, const CifTable& table, std::size_t wanted,
                          std::size_t& model_count, Remarks& remarks);

}  // namespace pliant
