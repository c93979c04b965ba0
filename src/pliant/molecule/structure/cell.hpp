// SPDX-License-Identifier: MIT
// The periodic cell (unit cell, box) of a crystal or a simulation, whose contents repeat along
// three edges.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "pliant/base/vec3.hpp"

namespace pliant {

/// Number of edges by which an atom is moved in each direction.
using CellShift = std::array<std::int32_t, 3>;
inline constexpr CellShift no_shift{0, 0, 0};

struct Cell {
  std::array<Vec3, 3> edges;  ///< Angstrom

  /// The vector (Angstrom) by which a shift moves an atom.
  Vec3 operator()(CellShift shift) const {
    return shift[0] * edges[0] + shift[1] * edges[1] + shift[2] * edges[2];
  }
  friend bool operator==(const Cell&, const Cell&) = default;
};

/// The cell of three edges (Angstrom). Nothing for edges that lie in a plane, are not finite, or of
/// which one is below 2 Angstrom, as in the cell of 1 1 1 that files use for "no cell".
std::optional<Cell> cell_of(const std::array<Vec3, 3>& edges);

/// The cell of given lengths (Angstrom) and angles (degrees: of b and c, of c and a, of a and b),
/// with a along x and b in the xy plane, as in PDB and mmCIF.
std::optional<Cell> cell_of(const std::array<double, 3>& lengths,
                            const std::array<double, 3>& degrees);

/// Finds periodic images.
class CellImages {
 public:
  explicit CellImages(const Cell& cell);

  const Cell& cell() const { return cell_; }

  /// (x, y, z) in units of the edges.
  Vec3 fractions(Vec3 position) const;
  /// The shift that makes a difference vector (Angstrom) shortest, provided that it is then shorter
  /// than half the width of the cell.
  CellShift to_nearest(Vec3 difference) const;
  /// The distances between opposite faces (Angstrom).
  std::array<double, 3> widths() const;

 private:
  Cell cell_;
  std::array<Vec3, 3> normals_;  ///< normals of the faces, of length 1 / width
};

}  // namespace pliant
