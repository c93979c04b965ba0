// SPDX-License-Identifier: MIT
// The contacts of a ligand that all frames keep.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pliant/conformers/rings/bond_chemistry.hpp"
#include "pliant/framework/framework.hpp"

namespace pliant {

/// What `hold` may name, "metal, ..., all or none", each between `quotes`.
std::string hold_names(std::string_view quotes = "");

/// Throws OptionError naming a word that is none of these.
void check_hold(std::span<const std::string> hold);

/// Returns (L) 1 where a limit belongs to a contact of a joint that is_ligand (N), of a kind that
/// `hold` names. A metal that is held keeps its other contacts, too. The charges of their groups
/// tell salt bridges from hydrogen bonds: ammonium, guanidinium, amidinium or imidazolium, and
/// carboxylate, phosphate or sulfonate.
std::vector<std::uint8_t> held_contacts(const Framework& framework, const BondChemistry& chemistry,
                                        const std::vector<bool>& is_ligand,
                                        std::span<const std::string> hold);

}  // namespace pliant
