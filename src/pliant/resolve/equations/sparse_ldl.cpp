// SPDX-License-Identifier: MIT
#include "pliant/resolve/equations/sparse_ldl.hpp"

#include <algorithm>
#include <limits>

#include "pliant/resolve/equations/bar_loops.hpp"

namespace pliant {
namespace {

/// Pairs of entries that share a column: what a factorization costs, in multiplications. Beyond so
/// many a bar (and in all) sweeps are the better choice, as for complete graphs.
constexpr std::uint64_t most_pairs_a_column = 500;
constexpr std::uint64_t pairs_that_never_hurt = 2000000;
constexpr auto none = std::numeric_limits<std::uint32_t>::max();

/// Columns grouped by their parent in the elimination tree (the row of their first entry).
class Children {
 public:
  explicit Children(std::uint32_t size) : first_(size, none), next_(size, none) {}
  void add(std::uint32_t parent, std::uint32_t child) {
    next_[child] = first_[parent];
    first_[parent] = child;
  }
  std::uint32_t first(std::uint32_t parent) const { return first_[parent]; }
  std::uint32_t next(std::uint32_t child) const { return next_[child]; }

 private:
  std::vector<std::uint32_t> first_, next_;
};

}  // namespace

SparseLdl::Range SparseLdl::append(std::uint32_t size, std::vector<Entry> entries) {
  const auto base = static_cast<std::uint32_t>(diagonal_.size());
  std::sort(entries.begin(), entries.end(), [](const Entry& x, const Entry& y) {
    return x.column != y.column ? x.column < y.column : x.row < y.row;
  });
  if (!find_pattern(size, base, entries)) {
    truncate(base);
    return {};
  }
  diagonal_.resize(base + size);
  inverse_.resize(base + size);
  lower_.resize(rows_.size());
  find_targets({base, base + size});
  return {base, base + size};
}

/// The pattern of a column: its own entries and those of its children in the elimination tree
/// (Davis, "Direct Methods for Sparse Linear Systems", 2006, chapter 4). False if it grows too far.
bool SparseLdl::find_pattern(std::uint32_t size, std::uint32_t base,
                             const std::vector<Entry>& entries) {
  const std::uint64_t most = std::max(pairs_that_never_hurt, most_pairs_a_column * size);
  Children children(size);
  std::vector<std::uint32_t> seen_by(size, none);
  std::size_t next_entry = 0;
  std::uint64_t pairs = 0;
  for (std::uint32_t k = 0; k < size; ++k) {
    const std::size_t begin = rows_.size();
    const auto add = [&](std::uint32_t row) {
      if (row == k || seen_by[row] == k) return;
      seen_by[row] = k;
      rows_.push_back(base + row);
    };
    for (; next_entry < entries.size() && entries[next_entry].column == k; ++next_entry)
      add(entries[next_entry].row);
    for (std::uint32_t child = children.first(k); child != none; child = children.next(child)) {
      const Range fill = column(base + child);
      for (std::uint32_t p = fill.begin; p < fill.end; ++p) add(rows_[p] - base);
    }
    std::sort(rows_.begin() + std::ptrdiff_t(begin), rows_.end());
    if (rows_.size() > begin) children.add(rows_[begin] - base, k);
    const std::uint64_t count = rows_.size() - begin;
    pairs += count * count / 2;
    if (pairs > most || rows_.size() >= none) return false;
    column_begin_.push_back(static_cast<std::uint32_t>(rows_.size()));
  }
  return true;
}

/// Where the product of entries (row, k) and (column, k) goes: entry (row, column).
void SparseLdl::find_targets(Range range) {
  for (std::uint32_t k = range.begin; k < range.end; ++k) {
    const Range own = column(k);
    for (std::uint32_t p = own.begin; p < own.end; ++p) {
      std::uint32_t place = column_begin_[rows_[p]];
      for (std::uint32_t q = p + 1; q < own.end; ++q) {
        while (rows_[place] != rows_[q]) ++place;
        targets_.push_back(place);
      }
    }
    target_begin_.push_back(targets_.size());
  }
}

void SparseLdl::truncate(std::uint32_t columns) {
  column_begin_.resize(columns + 1);
  rows_.resize(column_begin_.back());
}

std::int64_t SparseLdl::factor(Range range) {
  std::int64_t dropped = 0;
  factor_columns(pattern(), range.begin, range.end, diagonal_.data() + range.begin,
                 inverse_.data() + range.begin, lower_.data() + column_begin_[range.begin],
                 [&](bool drops) { dropped += drops; });
  return dropped;
}

void SparseLdl::solve(Range range, std::span<double> b) const {
  solve_columns(pattern(), range.begin, range.end, inverse_.data() + range.begin,
                lower_.data() + column_begin_[range.begin], b.data() + range.begin);
}

}  // namespace pliant
