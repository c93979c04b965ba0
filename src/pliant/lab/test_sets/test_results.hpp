// SPDX-License-Identifier: MIT
// Results of one heuristic (technique and weighting) for the forces of one graph of a test set: a
// table of one row a force, and its summary.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "pliant/text/file_text.hpp"

namespace pliant {

/// One force, resolved.
struct TestRow {
  std::int64_t sweeps = 0;  ///< one direction counts as one, as in the thesis
  /// in the reverse techniques forwards and backwards together count as one
  std::int64_t passes = 0;
  std::int64_t projections = 0;  ///< bars looked at
  bool converged = false;
  double final_residual = 0.0;  ///< largest |length - rest| / rest
};

/// Statistics of the sweeps over all forces of a graph.
struct TestSummary {
  std::int64_t forces = 0;
  std::int64_t converged = 0;  ///< number of forces that converged
  double mean = 0.0;
  std::int64_t mode = 0;  ///< the smallest of the most frequent values
  double sd = 0.0;        ///< with n - 1; 0 for a single force

  friend bool operator==(const TestSummary&, const TestSummary&) = default;
};

/// Throws InputError if there is no row.
TestSummary summary_of(std::span<const TestRow> rows);

/// CSV "force,sweeps,passes,projections,converged,final_residual", forces from 0 in their order,
/// converged true or false. Throws InputError naming force and column for a negative number or a
/// residual that is not finite.
std::string write_test_rows(std::span<const TestRow> rows);

/// Reads it back to the same bits. Throws InputError naming file, line and column, what was
/// expected and found.
std::vector<TestRow> parse_test_rows(const SourceText& source);

}  // namespace pliant
