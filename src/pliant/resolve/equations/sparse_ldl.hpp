// SPDX-License-Identifier: MIT
// L D L^T (square-root free Cholesky) of very sparse symmetric matrices with a fixed pattern and
// changing values. The positions of all entries are found once, so that a factorization is a single
// run through memory without search, branch or allocation. Molecules have two or three entries a
// column, for which general solvers spend most time on book-keeping.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "pliant/resolve/equations/bar_pattern.hpp"

namespace pliant {

/// Several matrices on one diagonal, as consecutive columns without common entries.
class SparseLdl {
 public:
  /// An entry below the diagonal.
  struct Entry {
    std::uint32_t column, row;
  };
  /// Columns that are factored together.
  using Range = PartRange;

  /// Appends a matrix of `size` columns; `entries` number its columns and rows from 0, in any
  /// order. Returns its columns, or none (and appends nothing) if the factor would have too many
  /// entries to be of use.
  Range append(std::uint32_t size, std::vector<Entry> entries);

  /// Entries below the diagonal of column k, with fill.
  Range column(std::uint32_t k) const { return {column_begin_[k], column_begin_[k + 1]}; }
  std::uint32_t row(std::uint32_t entry) const { return rows_[entry]; }
  std::size_t entry_count() const { return rows_.size(); }
  LdlPattern pattern() const {
    return {column_begin_.data(), rows_.data(), target_begin_.data(), targets_.data()};
  }

  /// The matrix to be factored; `factor` overwrites it.
  std::span<double> diagonal() { return diagonal_; }
  std::span<double> lower() { return lower_; }

  /// Factors a matrix. Columns whose pivot vanishes relative to their original diagonal entry
  /// depend on earlier ones and are left out: their unknown will be 0. Returns how many.
  std::int64_t factor(Range range);
  /// Solves in place; `b` is as long as the whole diagonal.
  void solve(Range range, std::span<double> b) const;

 private:
  bool find_pattern(std::uint32_t size, std::uint32_t base, const std::vector<Entry>& entries);
  void find_targets(Range range);
  void truncate(std::uint32_t columns);

  std::vector<std::uint32_t> column_begin_{0};  ///< (columns + 1) into rows_
  std::vector<std::uint32_t> rows_;
  std::vector<std::uint64_t> target_begin_{0};  ///< (columns + 1) into targets_
  std::vector<std::uint32_t> targets_;  ///< the entry that each pair of entries of a column changes
  std::vector<double> diagonal_, inverse_, lower_;
};

}  // namespace pliant
