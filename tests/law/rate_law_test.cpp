// SPDX-License-Identifier: MIT
// How fast sweeps converge, where linear algebra gives the answer in closed form. Near the solution
// a sweep acts on the errors of the bars as Gauss-Seidel on the matrix J J^T, whose entries are 2
// on the diagonal and the cosine between bars that share a joint beside it.
#include "pliant/framework/measures/residual.hpp"
#include "pliant/lab/examples/examples.hpp"
#include "pliant/resolve/resolve.hpp"
#include "pliant/resolve/techniques.hpp"
#include "support/frameworks.hpp"
#include "support/test.hpp"
#include "unit/resolve/gromacs_systems.hpp"

namespace pliant::rate_law_test {

/// Largest relative residuals after 0, 1, 2, ... sweeps of `input` with weighting 0.5.
std::vector<double> errors_by_sweep(const Framework& framework, std::vector<Vec3> x,
                                    std::int64_t sweeps) {
  Resolver resolver(framework, {"input", 0.5}, {.tolerance = {.relative = 1e-15}, .max_sweeps = 1});
  std::vector<double> errors{measure(framework, x).max_relative};
  for (std::int64_t k = 0; k < sweeps; ++k) errors.push_back(resolver.resolve(x).max_residual);
  return errors;
}

double mean_factor(const std::vector<double>& errors, std::size_t from, std::size_t to) {
  return std::pow(errors[to] / errors[from], 1.0 / double(to - from));
}

class StraightChainRate : public testing::TestWithParam<int> {};

/// cos^2(pi / (m + 1)) for m equal bars in a line: the tridiagonal matrix (-1, 2, -1) and Young's
/// theorem for consistently ordered matrices.
TEST_P(StraightChainRate, IsTheSquareOfTheJacobiRate) {
  const int m = GetParam();
  const Sketch sketch = straight_chain(std::size_t(m) + 1);
  std::vector<Vec3> x = sketch.positions;
  x[0].x -= 1e-3;  // along the line: the problem stays linear
  const double expected = std::pow(std::cos(std::numbers::pi / (m + 1)), 2);
  const auto sweeps = std::size_t(std::ceil(std::log(1e-6) / std::log(expected)));
  const auto errors = errors_by_sweep(framework_of(sketch), x, std::int64_t(sweeps));
  EXPECT_NEAR(mean_factor(errors, sweeps / 2, sweeps), expected, 0.002 * expected);
}

INSTANTIATE_TEST_SUITE_P(Bars, StraightChainRate, testing::Values(2, 3, 5, 10, 30));

class TwoBarRate : public testing::TestWithParam<double> {};

/// Two unit bars at an interior angle t: cos^2(t) / 4 a sweep; at a right angle one sweep is enough
/// to first order.
TEST_P(TwoBarRate, IsAQuarterOfTheSquaredCosine) {
  const double angle = GetParam() * std::numbers::pi / 180.0;
  Sketch sketch = straight_chain(3);
  sketch.positions[2] = {1.0 - std::cos(angle), std::sin(angle), 0.0};
  std::vector<Vec3> x = sketch.positions;
  x[0].x -= 1e-6;
  const auto errors = errors_by_sweep(framework_of(sketch), x, 3);
  const double expected = std::pow(std::cos(angle), 2) / 4.0;
  // The first sweep leaves the first bar off by what the second took from it.
  EXPECT_NEAR(errors[2] / errors[1], expected, 1e-4);
}

INSTANTIATE_TEST_SUITE_P(Degrees, TwoBarRate, testing::Values(60.0, 75.0, 120.0, 150.0, 180.0));

TEST(Rate, TwoBarsAtARightAngleNeedOneSweep) {
  const Sketch sketch = chain(3);
  std::vector<Vec3> x = sketch.positions;
  x[0].x -= 1e-6;
  EXPECT_LT(errors_by_sweep(framework_of(sketch), x, 1)[1], 1e-12);
}

TEST(Rate, EquilateralTriangleIsAnEighth) {
  const Sketch sketch = ring(3);
  const std::vector<Vec3> x = test::shake(framework_of(sketch), sketch.positions, 1e-3);
  const auto errors = errors_by_sweep(framework_of(sketch), x, 9);
  EXPECT_NEAR(mean_factor(errors, 5, 9), 0.125, 0.002);
}

/// GROMACS' test systems, pushed. Sweeps meet the same lengths as SHAKE elsewhere: they are held to
/// lengths, centre of mass and bar direction.
class PushedSystems : public testing::TestWithParam<test::GromacsSystem> {};

TEST_P(PushedSystems, MeetLengthsCentreOfMassAndDirection) {
  const Example& example = find_example(GetParam().name);
  for (const TechniqueEntry& entry : techniques()) {
    if (entry.forests_only && example.facts.cycles > 0) continue;
    SCOPED_TRACE(entry.name);
    std::vector<Vec3> x = GetParam().pushed;
    const ResolveSummary summary = resolve(example.framework, {std::string(entry.name), 0.5, true},
                                           x, {.tolerance = {.relative = 2e-5}});
    EXPECT_TRUE(summary.converged());
    const auto rests = example.framework.rest_lengths();
    for (std::size_t k = 0; k < rests.size(); ++k) {
      const Bar bar = example.framework.bars()[k];
      EXPECT_NEAR(distance(x[bar.a], x[bar.b]), rests[k], 2e-5 * rests[k] * (1 + 1e-12));
      EXPECT_GT(dot(x[bar.b] - x[bar.a], example.positions[bar.b] - example.positions[bar.a]), 0);
    }
    if (!entry.has_weighting) continue;
    const Vec3 moved = test::centre_of_mass(example.framework, x) -
                       test::centre_of_mass(example.framework, GetParam().pushed);
    EXPECT_LT(norm(moved), 1e-14 * test::extent(x));
  }
}

INSTANTIATE_TEST_SUITE_P(Gromacs, PushedSystems, testing::ValuesIn(test::gromacs_systems()),
                         [](const auto& row) { return std::string(row.param.name); });

/// Two joints, one bar: the answer in closed form, by the masses 1 and 12.
TEST(Rate, OneBarIsExact) {
  const Example& example = find_example("gmx_one_constraint_OH");
  std::vector<Vec3> x{{0.01, 0.08, 0.01}, {0.06, 0.01, -0.01}};
  const std::vector<Vec3> before = x;
  resolve(example.framework, {"input", 0.5, true}, x);
  const double d = distance(before[0], before[1]);
  const Vec3 excess = ((d - 0.1) / d) * (before[1] - before[0]);
  EXPECT_LT(distance(x[0], before[0] + (12.0 / 13.0) * excess), 1e-16);
  EXPECT_LT(distance(x[1], before[1] - (1.0 / 13.0) * excess), 1e-16);
}

/// |OB| |OD| = 5^2 - 3^2 in every position of Peaucellier's cell: broken in its plane and resolved,
/// the product is back.
TEST(Rate, PeaucelliersProductComesBack) {
  const Example& example = find_example("peaucellier_cell_2D");
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    std::vector<Vec3> x = test::shake(example.framework, example.positions, 0.3, seed);
    for (Vec3& p : x) p.z = 0.0;
    const ResolveSummary summary =
        resolve(example.framework, {"bfs_reverse", 0.5}, x, {.tolerance = {.relative = 1e-13}});
    ASSERT_TRUE(summary.converged());
    EXPECT_NEAR(distance(x[0], x[3]) * distance(x[0], x[4]), 16.0, 1e-10);
    EXPECT_EQ(x[3].z, 0.0);
  }
}

}  // namespace pliant::rate_law_test
