// SPDX-License-Identifier: MIT
// Modes of chains whose eigenvalues are known, and what they do to joints.
#include "pliant/sample/network/network_modes.hpp"

#include "pliant/base/math/normal.hpp"
#include "pliant/sample/network/lowest_modes.hpp"
#include "pliant/sample/network/mode_displacement.hpp"
#include "pliant/sample/network/mode_field.hpp"
#include "support/test.hpp"

namespace pliant::network_modes_test {

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
  EXPECT_ERROR(OptionError, "mode = 13: must be from 1 to 12, the modes of the network",
               mode_field(nodes, nodes.positions, 13, 0.3, "gnm"));
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

/// Q D Q^T with these eigenvalues, Q some reflections; row k of `axes` belongs to value k.
DenseMatrix with_spectrum(const std::vector<double>& values, DenseMatrix& axes) {
  const std::size_t n = values.size();
  axes = DenseMatrix(n, n);
  for (std::size_t k = 0; k < n; ++k) axes(k, k) = 1.0;
  for (std::uint64_t turn = 0; turn < 3; ++turn) {
    std::vector<double> v(n);
    RandomSequence draws({turn, Domain::amplitude, 0, 0, 0});
    fill_normal(draws, v);
    const double square = dot_product(v, v);
    for (std::size_t k = 0; k < n; ++k)
      add_scaled(-2.0 * dot_product(axes.row(k), v) / square, v, axes.row(k));
  }
  DenseMatrix a(n, n);
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = 0; i < n; ++i) add_scaled(values[k] * axes(k, i), axes.row(k), a.row(i));
  return a;
}

TEST(SymmetricEigen, FindsAGivenSpectrum) {
  std::vector<double> values{-3.0, -3.0, 0.0, 1e-8, 2.0, 2.0, 2.0, 5.0, 40.0};
  for (std::size_t n : {std::size_t{1}, std::size_t{2}, values.size()}) {
    const std::vector<double> some(values.begin(), values.begin() + std::ptrdiff_t(n));
    DenseMatrix axes;
    const DenseMatrix a = with_spectrum(some, axes);
    const EigenPairs found = symmetric_eigen(a);
    for (std::size_t k = 0; k < n; ++k) {
      EXPECT_NEAR(found.values[k], some[k], 1e-13);
      for (std::size_t i = 0; i < n; ++i)
        EXPECT_NEAR(dot_product(a.row(i), found.vectors.row(k)),
                    found.values[k] * found.vectors(k, i), 1e-12);
      for (std::size_t j = 0; j <= k; ++j)
        EXPECT_NEAR(dot_product(found.vectors.row(j), found.vectors.row(k)), j == k, 1e-13);
    }
  }
}

/// Below and above the size at which the inverse is taken; with a null space and equal values.
TEST(LowestModes, FindsTheLowestAboveTheNullSpace) {
  for (std::size_t n : {std::size_t{60}, std::size_t{360}}) {
    std::vector<double> values(n);
    for (std::size_t k = 0; k < n; ++k) values[k] = k < 6 ? 0.0 : 0.01 * double(k * k);
    values[10] = values[11] = values[12] = values[9];
    DenseMatrix axes;
    DenseMatrix a = with_spectrum(values, axes);
    DenseMatrix still(6, n);
    for (std::size_t k = 0; k < 6; ++k)
      std::copy(axes.row(k).begin(), axes.row(k).end(), still.row(k).begin());
    const EigenPairs found = lowest_modes(a, still, 20);
    ASSERT_EQ(found.values.size(), 20u);
    for (std::size_t k = 0; k < 20; ++k) {
      EXPECT_NEAR(found.values[k] / values[k + 6], 1.0, 1e-9) << n << " " << k;
      double within = 0.0;  // the share in the axes of this value
      for (std::size_t j = 0; j < n; ++j)
        if (std::abs(values[j] - values[k + 6]) < 1e-9)
          within += std::pow(dot_product(axes.row(j), found.vectors.row(k)), 2);
      EXPECT_NEAR(within, 1.0, 1e-9) << n << " " << k;
    }
  }
}

TEST(LowestModes, GivesFewerWhereThereAreFewer) {
  DenseMatrix axes;
  const DenseMatrix a = with_spectrum({0.0, 0.0, 1.0, 2.0}, axes);
  DenseMatrix still(1, 4);
  std::copy(axes.row(0).begin(), axes.row(0).end(), still.row(0).begin());
  EXPECT_EQ(lowest_modes(a, still, 10).values.size(), 2u);
}

TEST(LowestModes, SignsAreCanonical) {
  std::vector<double> v{0.5, -2.0, 2.0};
  make_sign_canonical(v);
  EXPECT_EQ(v, (std::vector<double>{-0.5, 2.0, -2.0}));
}

}  // namespace pliant::network_modes_test
