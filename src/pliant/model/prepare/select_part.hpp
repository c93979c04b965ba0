// SPDX-License-Identifier: MIT
// The part of a structure that a selection names: waters and ligands left out by a word.
#pragma once

#include <string_view>

#include "pliant/base/log.hpp"
#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

/// The atoms that `selection` names (words of select_atoms), as if the file held no others. Bonds
/// must be known (perceive_bonds): those to atoms that are left out vanish, and a warning says how
/// many. Throws OptionError if the selection cannot be understood or names no atom.
Structure select_part(const Structure& structure, std::string_view selection, const Log& log = {});

}  // namespace pliant
