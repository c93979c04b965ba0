// SPDX-License-Identifier: MIT
// Cell list (linked cells, grid search, bucketing): all pairs of points within a cut-off, in linear
// time. Cells are sorted, never hashed, so pairs come in the same order on every machine.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "pliant/base/vec3.hpp"

namespace pliant {

/// Points sorted into cubes a little wider than a cut-off. Only cubes that hold points take memory:
/// neither the extent of the points nor their offset from the origin matters.
class CellList {
 public:
  /// Takes `points` (N < 2^31, coordinates from -1e300 to 1e300 Angstrom) and a `cutoff` in
  /// [1e-6, 1e6] Angstrom.
  /// O(N) time and memory, unless the extent is above 4 * 10^9 cells: then O(N log N).
  CellList(std::span<const Vec3> points, double cutoff);

  /// Receives two points i < j and the square of their distance.
  using PairFunction = std::function<void(std::uint32_t i, std::uint32_t j, double squared)>;

  /// Calls `visit` once for each pair of points whose distance is at most the cut-off.
  /// O(N + pairs of points in adjacent cells).
  void for_each_pair(const PairFunction& visit) const;

  /// The points (ascending) that share their cell with more than `most` - 1 others: where the
  /// points are so dense that pairs would not be linear in their number.
  std::vector<std::uint32_t> points_in_cells_above(std::size_t most) const;

 private:
  struct Entry {
    std::uint64_t row;     ///< z << 32 | y of the cell
    std::uint32_t column;  ///< x of the cell
    std::uint32_t point;
  };
  struct Cell {
    std::uint32_t column;
    std::uint32_t first;  ///< index into entries_
  };
  struct Row {
    std::uint64_t key;
    std::uint32_t first;  ///< index into cells_
  };

  void index_cells();
  void visit_cell(std::size_t cell, const PairFunction& visit) const;
  void visit_cells(std::size_t one, std::size_t other, const PairFunction& visit) const;
  void visit_row(std::size_t row, const PairFunction& visit) const;
  void visit_rows(std::size_t one, std::size_t other, const PairFunction& visit) const;
  void visit_pair(std::size_t one, std::size_t other, const PairFunction& visit) const;

  double squared_cutoff_;
  std::vector<Entry> entries_;
  std::vector<Vec3> sorted_;  ///< points in the order of entries_
  std::vector<Cell> cells_;   ///< by row, then column; one more at the end
  std::vector<Row> rows_;     ///< by key; one more at the end
};

}  // namespace pliant
