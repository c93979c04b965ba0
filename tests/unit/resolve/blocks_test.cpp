// SPDX-License-Identifier: MIT
#include "pliant/resolve/blocks/blocks.hpp"

#include <Eigen/Dense>

#include "pliant/base/random.hpp"
#include "pliant/lab/examples/examples.hpp"
#include "pliant/resolve/equations/bar_elimination.hpp"
#include "pliant/resolve/equations/sparse_ldl.hpp"
#include "pliant/resolve/method/project_bar.hpp"
#include "pliant/resolve/resolve.hpp"
#include "support/frameworks.hpp"
#include "support/test.hpp"

namespace pliant::blocks_test {

/// A ring whose joints are up and down by turns.
Sketch crown(std::size_t n) {
  Sketch sketch = ring(n);
  for (std::size_t i = 1; i < n; i += 2) sketch.positions[i].z = 0.2;
  return sketch;
}

TEST(Blocks, ResolvesATreeExactlyInOnePass) {
  const Sketch tree{{{0, 0, 0}, {1.5, 0, 0}, {2, 1.4, 0}, {2, -1, 1}, {3.4, 1.6, 0.2}},
                    {{0, 1}, {1, 2}, {1, 3}, {2, 4}}};
  const Framework framework = framework_of(tree);
  std::vector<Vec3> y = test::shake(framework, tree.positions, 0.4);
  const ResolveSummary summary = resolve(framework, {"blocks"}, y, {{1e-14}});
  EXPECT_EQ(summary.stop, Stop::converged);
  EXPECT_EQ(summary.sweeps, 1);
  EXPECT_EQ(summary.projections, 4);
  EXPECT_LT(summary.max_residual, 1e-14);
}

class BlocksOfRings : public testing::TestWithParam<std::size_t> {};

TEST_P(BlocksOfRings, ResolvesInOnePassToRounding) {
  const Framework framework = framework_of(crown(GetParam()));
  std::vector<Vec3> y = test::shake(framework, crown(GetParam()).positions, 0.1);
  const Vec3 root_before = y[0];
  const ResolveSummary summary = resolve(framework, {"blocks"}, y, {{1e-13}});
  EXPECT_EQ(summary.stop, Stop::converged);
  EXPECT_EQ(summary.sweeps, 1);
  EXPECT_LT(summary.max_residual, 1e-13);
  EXPECT_EQ(y[0], root_before) << "the joint of entry is held still";
}

INSTANTIATE_TEST_SUITE_P(Sizes, BlocksOfRings, testing::Values(3, 4, 5, 6, 7, 8, 12, 24, 25, 60));

/// A planar centre with three neighbours: six bars that are rigid to second order only, where
/// sweeps crawl and plain Newton has nothing to divide by.
TEST(Blocks, ResolvesAPlanarCentreWhoseBarsAreRedundant) {
  const double h = std::sqrt(3.0) / 2.0;
  const Sketch sketch{{{0, 0, 0}, {1, 0, 0}, {-0.5, h, 0}, {-0.5, -h, 0}}, complete(4).bars};
  const Framework framework = framework_of(sketch);
  for (const double by : {0.01, 0.1, 0.3}) {
    std::vector<Vec3> y = test::shake(framework, sketch.positions, by);
    const ResolveSummary summary = resolve(framework, {"blocks"}, y, {{1e-8}});
    EXPECT_EQ(summary.stop, Stop::converged) << by;
    EXPECT_EQ(summary.sweeps, 1) << by;
  }
}

/// Joints in one place: a block that Newton's method does not part. The other block follows all the
/// same, and no sweep is needed where the shape before the push is known.
TEST(Blocks, ABlockThatCannotFollowItsPushFollowsAPartOfIt) {
  Sketch both = crown(9);
  for (Vec3 p : crown(9).positions) both.positions.push_back(p + Vec3{8, 0, 0});
  for (Bar bar : crown(9).bars) both.bars.push_back({bar.a + 9, bar.b + 9});
  both.bars.push_back({0, 9});
  const Framework framework = framework_of(both);
  std::vector<Vec3> x = test::shake(framework, both.positions, 0.05);
  x[3] = x[2];
  std::vector<Vec3> alone = x;
  const ResolveSummary without = Resolver(framework, {"blocks"}).resolve(alone, 12);
  EXPECT_GT(without.finishing_sweeps, 0);
  const std::vector<Vec3> pushed = x;
  const ResolveSummary summary = Resolver(framework, {"blocks"}).resolve(x, 12, 0, both.positions);
  EXPECT_TRUE(summary.converged());
  EXPECT_EQ(summary.finishing_sweeps, 0);
  EXPECT_EQ(summary.sweeps, 1);
  for (std::size_t k = 9; k < 18; ++k) EXPECT_LT(distance(x[k], pushed[k]), 0.2) << k;
}

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

/// No escape is asked for unless the joints coincide.
Vec3 never() {
  ADD_FAILURE() << "asked for an escape";
  return {};
}

TEST(ProjectBar, SharesTheCorrection) {
  Vec3 near{0, 0, 0}, far{3, 4, 0};
  project_bar(near, far, 10.0, 0.25, 0.75, never);
  EXPECT_LT(distance(near, Vec3{-0.75, -1.0, 0.0}), 1e-15);
  EXPECT_LT(distance(far, Vec3{5.25, 7.0, 0.0}), 1e-14);
  EXPECT_NEAR(distance(near, far), 10.0, 1e-14);
}

TEST(ProjectBar, WholeBarsStayBitForBitAndAllDoWithoutShares) {
  Vec3 near{0.1, 0.2, 0.3}, far{1.1, 0.7, -0.4};
  const Vec3 a = near, b = far;
  project_bar(near, far, distance(a, b), 0.5, 0.5, never);
  project_bar(near, far, 10.0, 0.0, 0.0, never);
  EXPECT_EQ(near, a);
  EXPECT_EQ(far, b);
}

/// Joints that coincide, or so nearly that the square of their distance underflows, part along the
/// direction that is asked for.
TEST(ProjectBar, CoincidentJointsPart) {
  for (double apart : {0.0, 1e-160, 9e-151}) {
    Vec3 near{1, 2, 3}, far = near;
    near = {0, 0, 0}, far = {apart, 0, 0};
    int asked = 0;
    project_bar(near, far, 2.0, 0.25, 0.75, [&] {
      ++asked;
      return Vec3{0, 0, 1};
    });
    EXPECT_EQ(asked, 1);
    EXPECT_EQ(near, (Vec3{0, 0, -0.5}));
    EXPECT_EQ(far, (Vec3{apart, 0, 1.5}));
  }
}

TEST(ProjectBar, TinyAndHugeBarsAreExact) {
  for (double scale : {1.1e-150, 1e-75, 1e75, 1e149}) {
    Vec3 near{0, 0, 0}, far{1.5 * scale, 0, 2.0 * scale};
    project_bar(near, far, scale, 0.5, 0.5, never);
    EXPECT_NEAR(distance(near, far) / scale, 1.0, 1e-15);
  }
}

}  // namespace pliant::blocks_test
