// SPDX-License-Identifier: MIT
// Cell list (linked cells, grid search, bucketing): all pairs of points within a cut-off, in linear
// time. Cells are sorted, never hashed, so pairs come in the same order on every machine.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
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

  /// Calls visit(i, j, squared) once for each pair of points i < j whose distance, of which
  /// `squared` is the square, is at most the cut-off. O(N + pairs of points in adjacent cells).
  template <class Visit>
  void for_each_pair(const Visit& visit) const;

  /// Returns the points (ascending) that share their cell with `most` others or more. Where points
  /// are so dense, the number of pairs is no longer linear in the number of points.
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
  template <class Visit>
  void visit_cell(std::size_t cell, const Visit& visit) const;
  template <class Visit>
  void visit_cells(std::size_t one, std::size_t other, const Visit& visit) const;
  template <class Visit>
  void visit_row(std::size_t row, const Visit& visit) const;
  template <class Visit>
  void visit_rows(std::size_t one, std::size_t other, const Visit& visit) const;
  template <class Visit>
  void visit_pair(std::size_t one, std::size_t other, const Visit& visit) const;

  double squared_cutoff_;
  std::vector<Entry> entries_;
  std::vector<Vec3> sorted_;  ///< points in the order of entries_
  std::vector<Cell> cells_;   ///< by row, then column; one more at the end
  std::vector<Row> rows_;     ///< by key; one more at the end
};

template <class Visit>
void CellList::for_each_pair(const Visit& visit) const {
  // Half of the eight rows around a row, as differences of z << 32 | y; rows are sorted by that
  // key, so a pointer for each only moves forward.
  constexpr std::uint64_t next_z = std::uint64_t{1} << 32;
  constexpr std::array<std::uint64_t, 4> steps{1, next_z - 1, next_z, next_z + 1};
  std::array<std::size_t, 4> ahead{};
  const std::size_t row_count = rows_.size() - 1;
  for (std::size_t row = 0; row < row_count; ++row) {
    visit_row(row, visit);
    for (std::size_t k = 0; k < steps.size(); ++k) {
      const std::uint64_t wanted = rows_[row].key + steps[k];
      while (ahead[k] < row_count && rows_[ahead[k]].key < wanted) ++ahead[k];
      if (ahead[k] < row_count && rows_[ahead[k]].key == wanted) visit_rows(row, ahead[k], visit);
    }
  }
}

/// Pairs within a row: in a cell, and between a cell and the next one.
template <class Visit>
void CellList::visit_row(std::size_t row, const Visit& visit) const {
  for (std::size_t cell = rows_[row].first; cell < rows_[row + 1].first; ++cell) {
    visit_cell(cell, visit);
    if (cell + 1 < rows_[row + 1].first && cells_[cell + 1].column == cells_[cell].column + 1)
      visit_cells(cell, cell + 1, visit);
  }
}

/// Pairs between two rows: each cell of the one with at most three of the other.
template <class Visit>
void CellList::visit_rows(std::size_t one, std::size_t other, const Visit& visit) const {
  std::size_t begin = rows_[other].first;
  const std::size_t end = rows_[other + 1].first;
  for (std::size_t cell = rows_[one].first; cell < rows_[one + 1].first; ++cell) {
    const std::uint64_t column = cells_[cell].column;
    while (begin < end && cells_[begin].column + std::uint64_t{1} < column) ++begin;
    for (std::size_t k = begin; k < end && cells_[k].column <= column + 1; ++k)
      visit_cells(cell, k, visit);
  }
}

template <class Visit>
void CellList::visit_cell(std::size_t cell, const Visit& visit) const {
  for (std::size_t i = cells_[cell].first; i < cells_[cell + 1].first; ++i)
    for (std::size_t j = i + 1; j < cells_[cell + 1].first; ++j) visit_pair(i, j, visit);
}

template <class Visit>
void CellList::visit_cells(std::size_t one, std::size_t other, const Visit& visit) const {
  for (std::size_t i = cells_[one].first; i < cells_[one + 1].first; ++i)
    for (std::size_t j = cells_[other].first; j < cells_[other + 1].first; ++j)
      visit_pair(i, j, visit);
}

template <class Visit>
void CellList::visit_pair(std::size_t one, std::size_t other, const Visit& visit) const {
  const double squared = norm_squared(sorted_[other] - sorted_[one]);
  if (!(squared <= squared_cutoff_)) return;
  const auto [i, j] = std::minmax(entries_[one].point, entries_[other].point);
  visit(i, j, squared);
}

}  // namespace pliant
