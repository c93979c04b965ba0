// SPDX-License-Identifier: MIT
// The periodic cell (unit cell, box) of a crystal or a simulation: what is in it repeats along
// three edges.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "pliant/base/vec3.hpp"

namespace pliant {

/// How often an atom is moved along each edge.
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

/// The cell of three edges (Angstrom). Nothing where they are none: they lie in a plane, are not
/// finite, or one is below 2 Angstrom, as in the cell of 1 1 1 that files hold for "no cell".
std::optional<Cell> cell_of(const std::array<Vec3, 3>& edges);

/// The same of lengths (Angstrom) and angles (degrees: of b and c, of c and a, of a and b), with a
/// along x and b in the plane of x and y, as PDB and mmCIF have it.
std::optional<Cell> cell_of(const std::array<double, 3>& lengths,
                            const std::array<double, 3>& degrees);

/// Finds images in one cell.
class CellImages {
 public:
  explicit CellImages(const Cell& cell);

  const Cell& cell() const { return cell_; }

  /// (x, y, z) in units of the edges.
  Vec3 fractions(Vec3 position) const;
  /// The shift that makes a difference (Angstrom) the shortest one that there is, where that is
  /// less than half as long as the cell is wide.
  CellShift to_nearest(Vec3 difference) const;
  /// The distances between opposite faces (Angstrom).
  std::array<double, 3> widths() const;

 private:
  Cell cell_;
  std::array<Vec3, 3> normals_;  ///< to the faces, of length 1 / width
};

}  // namespace pliant
