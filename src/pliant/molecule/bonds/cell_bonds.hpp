// SPDX-License-Identifier: MIT
// Bonds through the faces of a periodic cell: a step of bond perception. Not for users: see
// bonds.hpp.
#pragma once

#include <vector>

#include "pliant/molecule/bonds/perception.hpp"
#include "pliant/molecule/structure/cell.hpp"

namespace pliant::perception {

/// A bond a-b, where b has to be shifted to be beside a.
struct CellBond {
  std::uint32_t a, b;
  CellShift shift;
};

/// The bonds of atoms that the cell has parted, after the other steps of perception: bonds of the
/// file and of templates that are too long, links, and bonds by distance within a residue, each
/// where an image of the second atom is as near as bonded atoms are. Linear.
std::vector<CellBond> cell_bonds(const Perception& perception);

/// Longer than this (Angstrom) a bond that a file states is looked for through the cell. The
/// longest true ones are those of metals.
inline constexpr double longest_stated = 4.0;

}  // namespace pliant::perception
