// SPDX-License-Identifier: MIT
// Modes of chains whose eigenvalues are known, and what they do to joints.
#include "pliant/sample/network/network_modes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "pliant/base/error.hpp"
#include "pliant/sample/network/mode_displacement.hpp"
#include "pliant/sample/network/mode_field.hpp"
#include "support/error_text.hpp"

namespace pliant {
namespace network_modes_test {

/// Nodes on a line, each of its own chain: `gnm` reaches the next ones only.
NetworkNodes line(std::size_t count) {
  NetworkNodes nodes;
  for (std::uint32_t k = 0; k < count; ++k) {
    nodes.positions.push_back({9.0 * k, 0, 0});
    nodes.chain.push_back(k);
    nodes.of_joint.push_back(k);
  }
  return nodes;
}

/// Kirchhoff's matrix of a path has the eigenvalues 2 - 2 cos(pi k / n).
TEST(NetworkModes, OfAPathAreThoseOfTheBooks) {
  const NetworkModes modes = network_modes(line(6), "gnm");
  std::vector<double> expected;
  for (int k = 1; k < 6; ++k)
    for (int axis = 0; axis < 3; ++axis)
      expected.push_back(1.0 / (2.0 - 2.0 * std::cos(std::numbers::pi * k / 6)));
  ASSERT_EQ(modes.variances.size(), expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k)
    EXPECT_NEAR(modes.variances[k], expected[k], 1e-9);
}

TEST(NetworkModes, AreScaledToAnAmplitude) {
  NetworkModes modes = network_modes(line(5), "gnm");
  scale_to(0.7, modes);
  const std::vector<double> each = fluctuations(modes);
  double mean = 0.0;
  for (double value : each) mean += value / double(each.size());
  EXPECT_NEAR(mean, 0.7, 1e-12);
  EXPECT_NEAR(each.front(), each.back(), 1e-9);
  EXPECT_GT(each.front(), each[2]);  // ends move most
}

TEST(NetworkModes, UnknownNetworksAreRefused) {
  EXPECT_EQ(test::error_text<OptionError>([] {
              network_modes(line(3), "elastic");
            }).rfind("no network named \"elastic\"", 0),
            0U);
}

TEST(ModeField, HasTheAmplitudeThatWasAskedFor) {
  const NetworkNodes nodes = line(5);
  const auto field = mode_field(nodes, nodes.positions, 2, 0.3, "gnm");
  double squares = 0.0;
  for (Vec3 move : field) squares += norm_squared(move) / 5.0;
  EXPECT_NEAR(std::sqrt(squares), 0.3, 1e-12);
  EXPECT_EQ(
      test::error_text<OptionError>([&] { mode_field(nodes, nodes.positions, 13, 0.3, "gnm"); }),
      "mode = 13: must be from 1 to 12, the modes of the network");
}

struct Cube {
  NetworkNodes nodes;
  std::vector<Vec3> joints;  ///< one beside each node, and one without a node
};

Cube cube() {
  Cube made;
  for (std::uint32_t k = 0; k < 8; ++k) {
    const Vec3 corner{4.0 * (k & 1), 4.0 * (k >> 1 & 1), 4.0 * (k >> 2 & 1)};
    made.nodes.positions.push_back(corner);
    made.nodes.chain.push_back(k);
    made.nodes.of_joint.push_back(k);
    made.joints.push_back(corner + Vec3{0.5, -0.3, 1.0});
  }
  made.nodes.of_joint.push_back(no_node);
  made.joints.push_back({4.1, 4.2, 4.3});
  return made;
}

/// One mode in which the nodes turn about z: joints turn with them, wherever they are.
TEST(ModeDisplacement, JointsTurnAsNodesDo) {
  const Cube at = cube();
  NetworkModes turn{{1.0}, DenseMatrix(1, 24)};
  for (std::size_t k = 0; k < 8; ++k) {
    turn.directions(0, 3 * k) = -0.1 * at.nodes.positions[k].y;
    turn.directions(0, 3 * k + 1) = 0.1 * at.nodes.positions[k].x;
  }
  const ModeDisplacement moves(at.nodes, turn, at.joints);
  ASSERT_EQ(moves.mode_count(), 1U);
  std::vector<Vec3> out(at.joints.size());
  moves.displacements(std::vector<double>{2.0}, out);
  for (std::size_t k = 0; k < out.size(); ++k) {
    const Vec3 expected{-0.2 * at.joints[k].y, 0.2 * at.joints[k].x, 0.0};
    EXPECT_NEAR(distance(out[k], expected), 0.0, 1e-12) << k;
  }
}

TEST(ModeDisplacement, NoNodeGoesFurtherThanTheCap) {
  const Cube at = cube();
  NetworkModes shift{{4.0}, DenseMatrix(1, 24)};
  for (std::size_t k = 0; k < 8; ++k) shift.directions(0, 3 * k) = 1.0;
  const ModeDisplacement moves(at.nodes, shift, at.joints);
  std::vector<Vec3> out(at.joints.size());
  moves.displacements(std::vector<double>{1.5}, out);  // standard deviations, of 2 Angstrom each
  for (Vec3 move : out) EXPECT_NEAR(distance(move, {3, 0, 0}), 0.0, 1e-12);
  moves.displacements(std::vector<double>{100.0}, out);
  for (Vec3 move : out) EXPECT_NEAR(distance(move, {largest_node_move, 0, 0}), 0.0, 1e-12);
}

}  // namespace network_modes_test
}  // namespace pliant
