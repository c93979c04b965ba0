// SPDX-License-Identifier: MIT
#include "pliant/resolve/equations/sparse_ldl.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "pliant/base/random.hpp"
#include "pliant/resolve/equations/bar_elimination.hpp"

namespace pliant {
namespace sparse_ldl_test {

/// A random positive definite matrix with about `entries` entries below the diagonal.
Eigen::MatrixXd random_matrix(int size, int entries, std::uint64_t seed) {
  RandomSequence draws({seed, Domain::generate});
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size);
  for (int e = 0; e < entries; ++e) {
    const int row = int(draws.below(std::uint64_t(size))), column = int(draws.below(row + 1u));
    if (row != column) matrix(row, column) = matrix(column, row) = draws.uniform() - 0.5;
  }
  for (int k = 0; k < size; ++k) matrix(k, k) = 0.1 + matrix.row(k).cwiseAbs().sum();
  return matrix;
}

std::vector<SparseLdl::Entry> entries_of(const Eigen::MatrixXd& matrix) {
  std::vector<SparseLdl::Entry> entries;
  for (std::uint32_t column = 0; column < matrix.cols(); ++column)
    for (std::uint32_t row = column + 1; row < matrix.rows(); ++row)
      if (matrix(row, column) != 0.0) entries.push_back({column, row});
  return entries;
}

void set(SparseLdl& ldl, SparseLdl::Range range, const Eigen::MatrixXd& matrix) {
  for (std::uint32_t k = range.begin; k < range.end; ++k) {
    ldl.diagonal()[k] = matrix(k - range.begin, k - range.begin);
    for (std::uint32_t p = ldl.column(k).begin; p < ldl.column(k).end; ++p)
      ldl.lower()[p] = matrix(ldl.row(p) - range.begin, k - range.begin);
  }
}

/// Several matrices beside one another, each solved alone, against Eigen's dense solver.
TEST(SparseLdl, SolvesAsADenseSolverDoes) {
  SparseLdl ldl;
  std::vector<Eigen::MatrixXd> matrices;
  std::vector<SparseLdl::Range> ranges;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const int size = 1 + int(seed);
    matrices.push_back(random_matrix(size, 2 * size, seed));
    ranges.push_back(ldl.append(std::uint32_t(size), entries_of(matrices.back())));
    ASSERT_EQ(ranges.back().size(), std::uint32_t(size));
  }
  std::vector<double> b(ranges.back().end);
  for (std::size_t m = 0; m < matrices.size(); ++m) {
    const Eigen::VectorXd expected = Eigen::VectorXd::Random(matrices[m].rows());
    Eigen::Map<Eigen::VectorXd>(b.data() + ranges[m].begin, expected.size()) =
        matrices[m] * expected;
    set(ldl, ranges[m], matrices[m]);
    EXPECT_EQ(ldl.factor(ranges[m]), 0);
    ldl.solve(ranges[m], b);
    for (Eigen::Index k = 0; k < expected.size(); ++k)
      EXPECT_NEAR(b[ranges[m].begin + std::size_t(k)], expected[k], 1e-12);
  }
}

/// Two equal rows: the second is left out, and the first carries both.
TEST(SparseLdl, LeavesDependentColumnsOut) {
  SparseLdl ldl;
  const SparseLdl::Range range = ldl.append(3, {{0, 1}, {1, 2}, {0, 2}});
  Eigen::Matrix3d matrix;
  matrix << 2, 2, 1, 2, 2, 1, 1, 1, 3;
  set(ldl, range, matrix);
  EXPECT_EQ(ldl.factor(range), 1);
  std::vector<double> b{4, 4, 7};
  ldl.solve(range, b);
  EXPECT_NEAR(b[0], 1.0, 1e-15);
  EXPECT_EQ(b[1], 0.0);
  EXPECT_NEAR(b[2], 2.0, 1e-15);
}

TEST(SparseLdl, RefusesWhatWouldBeDense) {
  std::vector<SparseLdl::Entry> entries;
  for (std::uint32_t row = 1; row < 3000; ++row) entries.push_back({0, row});
  SparseLdl ldl;
  EXPECT_EQ(ldl.append(3000, entries).size(), 0u);
  EXPECT_EQ(ldl.append(2, {{0, 1}}).size(), 2u) << "and is none the worse for it";
  EXPECT_EQ(ldl.entry_count(), 1u);
}

/// Entries of the factor that were none of the matrix.
std::size_t fill_of(const std::vector<EquationEnds>& bars, std::size_t joints) {
  const std::vector<std::uint32_t> order = elimination_order(bars, joints);
  EXPECT_EQ(order.size(), bars.size());
  std::vector<SparseLdl::Entry> entries;
  for (std::uint32_t column = 0; column < order.size(); ++column)
    for (std::uint32_t row = column + 1; row < order.size(); ++row) {
      const EquationEnds one = bars[order[column]], other = bars[order[row]];
      if (one.a == other.a || one.a == other.b || one.b == other.a || one.b == other.b)
        entries.push_back({column, row});
    }
  SparseLdl ldl;
  EXPECT_EQ(ldl.append(std::uint32_t(bars.size()), entries).size(), bars.size());
  return ldl.entry_count() - entries.size();
}

TEST(BarElimination, TreesFactorWithoutFill) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    RandomSequence draws({seed, Domain::generate});
    std::vector<EquationEnds> bars;
    for (std::uint32_t joint = 1; joint < 60; ++joint)
      bars.push_back({std::uint32_t(draws.below(joint)), joint});
    for (std::size_t left = bars.size(); left > 1; --left)
      std::swap(bars[left - 1], bars[draws.below(left)]);
    EXPECT_EQ(fill_of(bars, 60), 0u) << seed;
  }
}

/// A ring of n bars with a tail at each joint: the tails fill nothing, the ring n - 3 entries.
TEST(BarElimination, ARingFillsOneEntryABar) {
  std::vector<EquationEnds> bars;
  for (std::uint32_t j = 0; j < 12; ++j) bars.push_back({j, (j + 1) % 12});
  EXPECT_EQ(fill_of(bars, 12), 9u);
  for (std::uint32_t j = 0; j < 12; ++j) bars.push_back({j, 12 + j});
  EXPECT_EQ(fill_of(bars, 24), 9u);
}

}  // namespace sparse_ldl_test
}  // namespace pliant
