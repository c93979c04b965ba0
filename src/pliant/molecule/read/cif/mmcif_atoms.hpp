// SPDX-License-Identifier: MIT
// The atom_site table of mmCIF.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "pliant/molecule/read/cif/cif_document.hpp"
#include "pliant/molecule/read/shared/atom_sites.hpp"

namespace pliant {

/// "1.234" for "1.234(5)", a value with its standard uncertainty.
std::string_view without_uncertainty(std::string_view text);

/// The character of an alternate location: its own where it is one, as in the PDB; of `labels`,
/// which have several, the first is 1, the second 2, ...; one that is not among them is 127.
char altloc_character(std::string_view label, std::span<const std::string_view> labels);

/// Reads the atoms of the `wanted` model (counted by order of appearance from 1; no atoms if there
/// are fewer); sets `model_count` to the number of models. Names, chains and residue numbers are
/// the author's (auth_...), as in the literature and other programs, or label_... where those are
/// missing. A chain ends where label_asym_id changes. Throws InputError for missing columns and
/// invalid values.
AtomSites read_atom_sites(const CifDocument& document, const CifTable& table, std::size_t wanted,
                          std::size_t& model_count, Remarks& remarks);

}  // namespace pliant
