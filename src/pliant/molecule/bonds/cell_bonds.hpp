// SPDX-License-Identifier: MIT
// Bonds through the faces of a periodic cell: a step of bond perception. Internal: users call
// bonds.hpp.
#pragma once

#include <vector>

#include "pliant/molecule/bonds/perception.hpp"
#include "pliant/molecule/structure/cell.hpp"

namespace pliant::perception {

/// A bond a-b, and the shift that brings b next to a.
struct CellBond {
  std::uint32_t a, b;
  CellShift shift;
};

/// Finds the bonds of atoms separated by the faces of the cell, after the other steps of
/// perception: bonds of the file and of templates that are too long, links, and bonds by distance
/// within a residue, where an image of the second atom is within bonding distance. Linear.
std::vector<CellBond> cell_bonds(const Perception& perception);

/// A bond of the file that is longer than this (Angstrom) is searched for through the cell. The
/// longest true bonds are those of metals.
inline constexpr double longest_stated = 4.0;

}  // namespace pliant::perception
