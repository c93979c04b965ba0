// SPDX-License-Identifier: MIT
#include "pliant/resolve/blocks/blocks.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "pliant/resolve/resolve.hpp"

namespace pliant {
namespace blocks_test {

Framework framework_at(const std::vector<Vec3>& positions, std::vector<Bar> bars,
                       std::vector<Joint> pinned = {}) {
  FrameworkParts parts;
  parts.joint_count = positions.size();
  parts.bars = std::move(bars);
  parts.pinned = std::move(pinned);
  for (Bar bar : parts.bars)
    parts.rest_lengths.push_back(distance(positions[bar.a], positions[bar.b]));
  return Framework(std::move(parts));
}

std::vector<Vec3> shaken(std::vector<Vec3> positions, double by) {
  for (std::size_t i = 0; i < positions.size(); ++i)
    positions[i] += by * RandomSequence({1, Domain::displacement, 0, 0, i}).direction();
  return positions;
}

std::vector<Vec3> ring_of(std::size_t n) {
  std::vector<Vec3> positions;
  const double radius = 0.75 / std::sin(M_PI / double(n));
  for (std::size_t i = 0; i < n; ++i) {
    const double t = 2.0 * M_PI * double(i) / double(n);
    positions.push_back({radius * std::cos(t), radius * std::sin(t), i % 2 ? 0.3 : 0.0});
  }
  return positions;
}

std::vector<Bar> cycle_bars(std::size_t n) {
  std::vector<Bar> bars;
  for (std::size_t i = 0; i < n; ++i)
    bars.push_back({static_cast<Joint>(i), static_cast<Joint>((i + 1) % n)});
  return bars;
}

TEST(Blocks, ResolvesATreeExactlyInOnePass) {
  const std::vector<Vec3> x{{0, 0, 0}, {1.5, 0, 0}, {2, 1.4, 0}, {2, -1, 1}, {3.4, 1.6, 0.2}};
  const Framework framework = framework_at(x, {{0, 1}, {1, 2}, {1, 3}, {2, 4}});
  std::vector<Vec3> y = shaken(x, 0.4);
  const ResolveSummary summary = resolve(framework, {"blocks"}, y, {{1e-14}});
  EXPECT_EQ(summary.stop, Stop::converged);
  EXPECT_EQ(summary.sweeps, 1);
  EXPECT_EQ(summary.projections, 4);
  EXPECT_LT(summary.max_residual, 1e-14);
}

class BlocksOfRings : public testing::TestWithParam<std::size_t> {};

TEST_P(BlocksOfRings, ResolvesInOnePassToRounding) {
  const std::vector<Vec3> x = ring_of(GetParam());
  const Framework framework = framework_at(x, cycle_bars(GetParam()));
  std::vector<Vec3> y = shaken(x, 0.1);
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
  const std::vector<Vec3> x{{0, 0, 0}, {1, 0, 0}, {-0.5, h, 0}, {-0.5, -h, 0}};
  const Framework framework = framework_at(x, {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}});
  for (const double by : {0.01, 0.1, 0.3}) {
    std::vector<Vec3> y = shaken(x, by);
    const ResolveSummary summary = resolve(framework, {"blocks"}, y, {{1e-8}});
    EXPECT_EQ(summary.stop, Stop::converged) << by;
    EXPECT_EQ(summary.sweeps, 1) << by;
  }
}

TEST(Blocks, PinnedJointsStayAndTheBarsBetweenThemAreSwept) {
  const std::vector<Vec3> x{{0, 0, 0}, {1, 0.2, 0}, {2, 0, 0}, {3, 0.3, 0}, {4, 0, 0}};
  const Framework framework = framework_at(x, {{0, 1}, {1, 2}, {2, 3}, {3, 4}}, {0, 4});
  std::vector<Vec3> y = x;
  y[1] += Vec3{0.0, 0.2, 0.1};
  y[2] += Vec3{0.1, 0.0, -0.1};
  const ResolveSummary summary = resolve(framework, {"blocks"}, y, {{1e-9}});
  EXPECT_EQ(summary.stop, Stop::converged);
  EXPECT_EQ(y[0], x[0]);
  EXPECT_EQ(y[4], x[4]);
}

TEST(Blocks, SaysThatAnImpossibleTriangleDoesNotConverge) {
  FrameworkParts parts;
  parts.joint_count = 3;
  parts.bars = {{0, 1}, {1, 2}, {0, 2}};
  parts.rest_lengths = {1, 1, 3};
  const Framework framework(std::move(parts));
  std::vector<Vec3> y{{0, 0, 0}, {1, 0.1, 0}, {2, 0, 0}};
  ResolveOptions options;
  options.max_sweeps = 100;
  const ResolveSummary summary = resolve(framework, {"blocks"}, y, options);
  EXPECT_EQ(summary.stop, Stop::max_sweeps);
  EXPECT_GT(summary.max_residual, 0.1);
  for (Vec3 p : y) EXPECT_TRUE(is_finite(p));
}

/// Joints in one place: a block that Newton's method does not part. The other block follows all the
/// same, and no sweep is needed where the shape before the push is known.
TEST(Blocks, ABlockThatCannotFollowItsPushFollowsAPartOfIt) {
  std::vector<Vec3> positions = ring_of(9);
  for (Vec3 p : ring_of(9)) positions.push_back(p + Vec3{8, 0, 0});
  std::vector<Bar> bars = cycle_bars(9);
  for (Bar bar : cycle_bars(9)) bars.push_back({bar.a + 9, bar.b + 9});
  bars.push_back({0, 9});
  const Framework framework = framework_at(positions, bars);
  std::vector<Vec3> x = shaken(positions, 0.05);
  x[3] = x[2];
  std::vector<Vec3> alone = x;
  const ResolveSummary without = Resolver(framework, {"blocks"}).resolve(alone, 12);
  EXPECT_GT(without.finishing_sweeps, 0);
  const std::vector<Vec3> pushed = x;
  const ResolveSummary summary = Resolver(framework, {"blocks"}).resolve(x, 12, 0, positions);
  EXPECT_TRUE(summary.converged());
  EXPECT_EQ(summary.finishing_sweeps, 0);
  EXPECT_EQ(summary.sweeps, 1);
  for (std::size_t k = 9; k < 18; ++k) EXPECT_LT(distance(x[k], pushed[k]), 0.2) << k;
}

}  // namespace blocks_test
}  // namespace pliant
