// SPDX-License-Identifier: MIT
// Removes atoms from a structure and adds others, with all columns and bonds.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "pliant/model/atoms/atom_graph.hpp"
#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

/// A structure made from another, and the original index of each atom; no_atom for a new one.
struct EditedStructure {
  Structure structure;
  std::vector<std::uint32_t> origin;  ///< (N)
};

/// An atom to be added to the residue of `parent`, after its other atoms.
struct NewAtom {
  std::uint32_t parent;
  std::string name;
  std::uint8_t element;
  Vec3 position;
  bool is_bonded = true;  ///< to the parent
};

/// Removes the marked atoms (N), and residues that lose all atoms.
EditedStructure without_atoms(const Structure& structure, const std::vector<bool>& is_out);

/// Adds atoms. Serials are renumbered from 1 if there are any.
EditedStructure with_atoms(const Structure& structure, const std::vector<NewAtom>& added);

}  // namespace pliant
