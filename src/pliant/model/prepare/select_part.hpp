// SPDX-License-Identifier: MIT
// Reduces a structure to a selection, for example without waters and ligands.
#pragma once

#include <string_view>

#include "pliant/base/log.hpp"
#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

/// Keeps the atoms of `selection` (as in select_atoms), as if the file held no others. Bonds must
/// be known (perceive_bonds): those to atoms that are left out are removed, and a warning gives
/// their number. Throws OptionError if the selection is invalid or selects no atom.
Structure select_part(const Structure& structure, std::string_view selection, const Log& log = {});

}  // namespace pliant
