// SPDX-License-Identifier: MIT
#include "pliant/base/math/cell_list.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace pliant {
namespace {

// Wider than the cut-off, so that rounding in (x - lowest) / edge never puts two points within the
// cut-off two cells apart: at 2^46 cells the rounding error is 2^-7 cells.
constexpr double edge_over_cutoff = 1.01;

double coordinate(Vec3 p, int axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

/// Numbers the occupied cells of an axis so wide that its cells cannot be counted in 32 bits:
/// neighbouring cells get consecutive numbers, others leave one number between them.
std::vector<std::uint32_t> numbered(const std::vector<double>& cells) {
  std::vector<double> occupied(cells);
  std::sort(occupied.begin(), occupied.end());
  occupied.erase(std::unique(occupied.begin(), occupied.end()), occupied.end());
  std::vector<std::uint32_t> numbers(occupied.size(), 0);
  for (std::size_t k = 1; k < occupied.size(); ++k)
    numbers[k] = numbers[k - 1] + (occupied[k] - occupied[k - 1] > 1.0 ? 2 : 1);
  std::vector<std::uint32_t> result;
  result.reserve(cells.size());
  for (double cell : cells) {
    const auto at = std::lower_bound(occupied.begin(), occupied.end(), cell);
    result.push_back(numbers[static_cast<std::size_t>(at - occupied.begin())]);
  }
  return result;
}

/// The cell of each point along one axis, from 0.
std::vector<std::uint32_t> axis_cells(std::span<const Vec3> points, int axis, double edge) {
  constexpr double most = 4e9;
  std::vector<double> cells;
  cells.reserve(points.size());
  double lowest = coordinate(points[0], axis), highest = lowest;
  for (Vec3 p : points) {
    lowest = std::min(lowest, coordinate(p, axis));
    highest = std::max(highest, coordinate(p, axis));
  }
  for (Vec3 p : points) cells.push_back(std::floor((coordinate(p, axis) - lowest) / edge));
  if (!((highest - lowest) / edge < most)) return numbered(cells);
  return {cells.begin(), cells.end()};
}

/// Stable counting sort by one digit of `key`, `bits` wide.
template <class Entry, class Key>
void sort_by_digit(std::vector<Entry>& entries, const Key& key, int shift) {
  constexpr std::uint64_t digits = 4096;
  std::array<std::uint32_t, digits + 1> first{};
  const auto digit = [&](const Entry& e) { return (key(e) >> shift) & (digits - 1); };
  for (const Entry& e : entries) ++first[digit(e) + 1];
  for (std::size_t d = 0; d < digits; ++d) first[d + 1] += first[d];
  std::vector<Entry> sorted(entries.size());
  for (const Entry& e : entries) sorted[first[digit(e)]++] = e;
  entries.swap(sorted);
}

/// Radix sort by a 32-bit key: as many passes as the largest key needs.
template <class Entry, class Key>
void sort_by(std::vector<Entry>& entries, const Key& key) {
  std::uint64_t largest = 0;
  for (const Entry& e : entries) largest = std::max<std::uint64_t>(largest, key(e));
  for (int shift = 0; largest >> shift != 0; shift += 12) sort_by_digit(entries, key, shift);
}

}  // namespace

CellList::CellList(std::span<const Vec3> points, double cutoff) : squared_cutoff_(cutoff * cutoff) {
  if (!points.empty()) {
    const double edge = cutoff * edge_over_cutoff;
    const auto x = axis_cells(points, 0, edge), y = axis_cells(points, 1, edge),
               z = axis_cells(points, 2, edge);
    entries_.reserve(points.size());
    for (std::uint32_t i = 0; i < points.size(); ++i)
      entries_.push_back({std::uint64_t{z[i]} << 32 | y[i], x[i], i});
  }
  sort_by(entries_, [](const Entry& e) { return std::uint64_t{e.column}; });
  sort_by(entries_, [](const Entry& e) { return e.row & 0xffffffffU; });
  sort_by(entries_, [](const Entry& e) { return e.row >> 32; });
  sorted_.reserve(points.size());
  for (const Entry& e : entries_) sorted_.push_back(points[e.point]);
  index_cells();
}

void CellList::index_cells() {
  for (std::uint32_t k = 0; k < entries_.size(); ++k) {
    const bool new_row = k == 0 || entries_[k].row != entries_[k - 1].row;
    if (new_row) rows_.push_back({entries_[k].row, static_cast<std::uint32_t>(cells_.size())});
    if (new_row || entries_[k].column != entries_[k - 1].column)
      cells_.push_back({entries_[k].column, k});
  }
  rows_.push_back({0, static_cast<std::uint32_t>(cells_.size())});
  cells_.push_back({0, static_cast<std::uint32_t>(entries_.size())});
}

std::vector<std::uint32_t> CellList::points_in_cells_above(std::size_t most) const {
  std::vector<std::uint32_t> points;
  for (std::size_t cell = 0; cell + 1 < cells_.size(); ++cell) {
    const std::size_t first = cells_[cell].first, last = cells_[cell + 1].first;
    if (last - first <= most) continue;
    for (std::size_t k = first; k < last; ++k) points.push_back(entries_[k].point);
  }
  std::sort(points.begin(), points.end());
  return points;
}

}  // namespace pliant
