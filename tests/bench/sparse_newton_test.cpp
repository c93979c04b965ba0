// SPDX-License-Identifier: MIT
// The peer of the race with angles is what it is said to be: all bars of its own at their lengths,
// corrections along the directions before the push, divided by mass, and steps that square errors.
#include <Eigen/Dense>

#include "bench/sparse_newton.hpp"
#include "pliant/base/random.hpp"
#include "support/test.hpp"

namespace pliant::bench {
namespace {

/// Every pair of these joints has a bar, as in a CX4 with its angles.
Framework all_pairs(const std::vector<Vec3>& positions, std::vector<double> masses = {}) {
  FrameworkParts parts{.joint_count = positions.size()};
  for (Joint a = 0; a < positions.size(); ++a)
    for (Joint b = a + 1; b < positions.size(); ++b) {
      const Vec3 along = positions[b] - positions[a];
      parts.bars.push_back({a, b});
      parts.rest_lengths.push_back(std::sqrt(dot(along, along)));
    }
  parts.masses = std::move(masses);
  return Framework(std::move(parts));
}

const std::vector<Vec3> methane = {{0.0, 0.0, 0.0},
                                   {0.63, 0.63, 0.63},
                                   {-0.63, -0.63, 0.63},
                                   {-0.63, 0.63, -0.63},
                                   {0.63, -0.63, -0.63}};
const std::vector<Vec3> planar = {
    {0.0, 0.0, 0.0}, {1.3, 0.0, 0.0}, {-0.7, 1.1, 0.0}, {-0.7, -1.2, 0.0}};

std::vector<Vec3> pushed(std::vector<Vec3> positions, double size) {
  for (std::size_t joint = 0; joint < positions.size(); ++joint) {
    RandomSequence random({.seed = 7, .domain = Domain::displacement, .joint = joint});
    positions[joint] += size * random.direction();
  }
  return positions;
}

TEST(IndependentBars, HaveTheRankOfTheRigidityMatrix) {
  EXPECT_EQ(independent_bars(all_pairs(methane), methane, 1e-6).size(), 3u * 5 - 6);
  // Four joints of a plane: distances say nothing of the motion out of it.
  EXPECT_EQ(independent_bars(all_pairs(planar), planar, 1e-6).size(), 2u * 4 - 3);
}

class SparseNewtonOn : public testing::TestWithParam<NewtonMatrix> {};

TEST_P(SparseNewtonOn, AMoleculeMakesItWholeAlongTheOldDirections) {
  const std::vector<double> masses = {12.0, 1.0, 2.0, 3.0, 1.0};
  const Framework framework = all_pairs(methane, masses);
  SparseNewton newton(framework, independent_bars(framework, methane, 1e-6), GetParam());
  const auto broken = pushed(methane, 0.05);
  auto positions = broken;
  const int steps = newton.resolve(positions, methane, 1e-12);
  ASSERT_GT(steps, 0);
  EXPECT_LE(newton.error(positions), 1e-12);
  if (GetParam() == NewtonMatrix::unsymmetric) {
    EXPECT_LE(steps, 5);
  }

  // Its moves times masses are a combination of the nine directions: nothing is left over.
  Eigen::MatrixXd span = Eigen::MatrixXd::Zero(15, static_cast<int>(newton.bars().size()));
  Eigen::VectorXd moved(15);
  for (int joint = 0; joint < 5; ++joint) {
    const auto k = static_cast<std::size_t>(joint);
    const Vec3 move = masses[k] * (positions[k] - broken[k]);
    moved.segment<3>(3 * joint) << move.x, move.y, move.z;
  }
  for (int column = 0; column < span.cols(); ++column) {
    const Bar bar = framework.bars()[newton.bars()[static_cast<std::size_t>(column)]];
    const Vec3 s = methane[bar.b] - methane[bar.a];
    span.col(column).segment<3>(3 * static_cast<int>(bar.b)) << s.x, s.y, s.z;
    span.col(column).segment<3>(3 * static_cast<int>(bar.a)) << -s.x, -s.y, -s.z;
  }
  const Eigen::VectorXd shares = span.colPivHouseholderQr().solve(moved);
  EXPECT_LE((span * shares - moved).norm(), 1e-12 * (1.0 + moved.norm()));
}

TEST_P(SparseNewtonOn, WhatItCannotMakeWholeIsSaid) {
  const Framework framework = all_pairs(methane);
  SparseNewton newton(framework, independent_bars(framework, methane, 1e-6), GetParam());
  std::vector<Vec3> positions = methane;
  positions[1] = {1e200, 0.0, 0.0};
  EXPECT_EQ(newton.resolve(positions, methane, 1e-12), -1);
  positions = pushed(methane, 0.05);
  EXPECT_EQ(newton.resolve(positions, methane, 1e-12, 1), -1);
}

INSTANTIATE_TEST_SUITE_P(Both, SparseNewtonOn,
                         testing::Values(NewtonMatrix::unsymmetric, NewtonMatrix::symmetric));

}  // namespace
}  // namespace pliant::bench
