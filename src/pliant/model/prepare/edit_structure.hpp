// SPDX-License-Identifier: MIT
// Taking atoms out of a structure and putting some in: every column and bond follows.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pliant/model/atoms/atom_graph.hpp"
#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

/// A structure made of another, and which atom of that each of its atoms is; no_atom: a new one.
struct EditedStructure {
  Structure structure;
  std::vector<std::uint32_t> origin;  ///< (N)
};

/// An atom to put in, into the residue of `parent`, after all others.
struct NewAtom {
  std::uint32_t parent;
  std::string name;
  std::uint8_t element;
  Vec3 position;
  bool is_bonded = true;  ///< to the parent
};

/// Without the atoms that are marked (N); residues that lose all atoms go, too.
EditedStructure without_atoms(const Structure& structure, const std::vector<bool>& is_out);

/// With `added` atoms besides. Serial numbers are 1 to N anew if there are any.
EditedStructure with_atoms(const Structure& structure, const std::vector<NewAtom>& added);

}  // namespace pliant
