// SPDX-License-Identifier: MIT
#include "pliant/sample/network/elastic_network.hpp"

#include "pliant/sample/network/b_factors.hpp"
#include "pliant/sample/network/coarse_nodes.hpp"
#include "pliant/sample/network/domains.hpp"
#include "support/test.hpp"

namespace pliant::elastic_network_test {

DenseMatrix one_spring(double k) {
  DenseMatrix springs(2, 2);
  springs(0, 1) = springs(1, 0) = k;
  return springs;
}

TEST(ElasticNetwork, ASpringIsStiffAlongItselfOnly) {
  const std::vector<Vec3> x{{0, 0, 0}, {3, 0, 4}};
  const DenseMatrix h = stiffness(x, one_spring(2.0), true);
  const double n[3] = {0.6, 0.0, 0.8};
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t b = 0; b < 3; ++b) {
      EXPECT_NEAR(h(a, b), 2.0 * n[a] * n[b], 1e-15);
      EXPECT_NEAR(h(a, b + 3), -2.0 * n[a] * n[b], 1e-15);
    }
  const DenseMatrix kirchhoff = stiffness(x, one_spring(2.0), false);
  EXPECT_EQ(kirchhoff.rows(), 2U);
  EXPECT_EQ(kirchhoff(0, 0), 2.0);
  EXPECT_EQ(kirchhoff(0, 1), -2.0);
}

TEST(ElasticNetwork, RigidMotionsAreSixFiveOrOne) {
  const std::vector<Vec3> line{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}},
      bent{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}};
  EXPECT_EQ(rigid_motions(bent, true).rows(), 6U);
  EXPECT_EQ(rigid_motions(line, true).rows(), 5U);
  const DenseMatrix shift = rigid_motions(bent, false);
  ASSERT_EQ(shift.rows(), 1U);
  for (double value : shift.row(0)) EXPECT_NEAR(value, std::sqrt(1.0 / 3), 1e-15);
}

TEST(ElasticNetwork, SpringsAreThoseOfThePages) {
  NetworkNodes nodes{{{0, 0, 0}, {9, 0, 0}, {14, 0, 0}}, {0, 1, 2}, {}};
  const auto springs = [&](const char* name) { return find_network(name).springs(nodes).contacts; };
  EXPECT_EQ(springs("anm")(0, 2), 1.0);  // within 15
  EXPECT_EQ(springs("gnm")(0, 1), 1.0);  // within 10
  EXPECT_EQ(springs("gnm")(0, 2), 0.0);
  EXPECT_NEAR(springs("pfanm")(1, 2), 1.0 / 25, 1e-15);
}

TEST(ElasticNetwork, BadNodesAreRefused) {
  const NetworkNodes good{{{0, 0, 0}, {1, 0, 0}}, {0, 0}, {0, 1, no_node}};
  EXPECT_NO_THROW(check(good, 3));
  EXPECT_ERROR(Error, "network: nodes of 3 joints for 2", check(good, 2));
  const double nan = std::nan("");
  const std::pair<const char*, NetworkNodes> cases[] = {
      {"network: 0 nodes; it needs 2 or more", {{}, {0, 0}, {0, 1, no_node}}},
      {"network: 1 chains for 2 nodes", {good.positions, {0}, {0, 1, no_node}}},
      {"network: node 2 of 2 does not exist", {good.positions, {0, 0}, {0, 2, no_node}}},
      {"network: the position of node 1 is not finite",
       {{{0, 0, 0}, {1, nan, 0}}, {0, 0}, {0, 1, no_node}}}};
  for (const auto& [text, nodes] : cases) EXPECT_ERROR(Error, text, check(nodes, 3));
}

/// A helix of alpha carbons: 3.6 residues a turn, 1.5 Angstrom a residue.
NetworkNodes helix(std::size_t count, std::uint32_t chain = 0, Vec3 shift = {}) {
  NetworkNodes nodes;
  for (std::size_t k = 0; k < count; ++k) {
    const double turn = 2.0 * 3.14159265358979 * double(k) / 3.6;
    nodes.positions.push_back(shift +
                              Vec3{2.3 * std::cos(turn), 2.3 * std::sin(turn), 1.5 * double(k)});
    nodes.chain.push_back(chain);
  }
  return nodes;
}

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

TEST(BFactors, AreLargestAtTheEndsOfAHelixAndAlikeAtBoth) {
  const std::vector<double> values = relative_b_factors(helix(40));
  EXPECT_NEAR(mean_of(values), 1.0, 1e-12);
  for (std::size_t k = 0; k < 40; ++k) {
    EXPECT_NEAR(values[k], values[39 - k], 1e-9);
    EXPECT_LE(values[k], values[0]);
  }
}

// Two nodes a spring k apart move by 1 / (4 k) each: alike.
TEST(BFactors, OfTwoNodesAreAlike) {
  for (double value : relative_b_factors(helix(2))) EXPECT_NEAR(value, 1.0, 1e-12);
}

TEST(BFactors, OfPartsThatNothingJoinsAreThoseOfEach) {
  NetworkNodes both = helix(20);
  const NetworkNodes other = helix(20, 1, {5000.0, 0.0, 0.0});
  both.positions.insert(both.positions.end(), other.positions.begin(), other.positions.end());
  both.chain.insert(both.chain.end(), other.chain.begin(), other.chain.end());
  const std::vector<double> values = relative_b_factors(both),
                            alone = relative_b_factors(helix(20));
  for (std::size_t k = 0; k < 20; ++k) {
    EXPECT_NEAR(values[k], alone[k], 1e-9);
    EXPECT_NEAR(values[20 + k], alone[k], 1e-9);
  }
}

TEST(BFactors, OfALoneNodeAreNone) {
  NetworkNodes nodes = helix(10);
  nodes.positions.push_back({900.0, 0.0, 0.0});
  nodes.chain.push_back(1);
  EXPECT_EQ(relative_b_factors(nodes).back(), 0.0);
}

TEST(BFactors, OfManyAreSharedByNeighbours) {
  const std::vector<double> values = relative_b_factors(helix(3500));
  EXPECT_EQ(values[100], values[101]);
  EXPECT_NEAR(mean_of(values), 1.0, 1e-9);
}

/// A straight chain of nodes 3.8 Angstrom apart, and lone ones on a cubic grid of 2 Angstrom.
NetworkNodes chain_and_grid(std::size_t length, int side) {
  NetworkNodes nodes;
  for (std::size_t k = 0; k < length; ++k) {
    nodes.positions.push_back({3.8 * double(k), 0.0, -40.0});
    nodes.chain.push_back(0);
  }
  for (int x = 0; x < side; ++x)
    for (int y = 0; y < side; ++y)
      for (int z = 0; z < side; ++z) {
        nodes.positions.push_back({2.0 * x, 2.0 * y, 2.0 * z});
        nodes.chain.push_back(static_cast<std::uint32_t>(nodes.chain.size()));
      }
  for (std::size_t k = 0; k < nodes.chain.size(); ++k)
    nodes.of_joint.push_back(static_cast<std::uint32_t>(k));
  nodes.of_joint.push_back(no_node);
  return nodes;
}

TEST(CoarseNodes, FewStayAsTheyAre) {
  const NetworkNodes nodes = coarsened(chain_and_grid(10, 1), 11);
  EXPECT_EQ(nodes.positions.size(), 11U);
  EXPECT_EQ(nodes.scale, 1.0);
}

TEST(CoarseNodes, ThoseOfAChainAreMergedAtTheirMeanAndSpringsGrow) {
  const NetworkNodes nodes = coarsened(chain_and_grid(16, 0), 2);
  ASSERT_EQ(nodes.positions.size(), 2U);
  EXPECT_NEAR(nodes.positions[0].x, 3.8 * 3.5, 1e-9);
  EXPECT_NEAR(nodes.positions[1].x, 3.8 * 11.5, 1e-9);
  EXPECT_NEAR(nodes.scale, 2.0, 1e-9);
  EXPECT_EQ(nodes.of_joint[7], 0U);
  EXPECT_EQ(nodes.of_joint[8], 1U);
  EXPECT_EQ(nodes.of_joint[16], no_node);
}

TEST(CoarseNodes, ThousandsOfLoneAtomsBecomeAFewEachNear) {
  const NetworkNodes before = chain_and_grid(200, 16);
  const NetworkNodes nodes = coarsened(before, 200);
  EXPECT_LE(nodes.positions.size(), 200U);
  EXPECT_EQ(nodes.of_joint.size(), before.of_joint.size());
  check(nodes, before.of_joint.size());
  double furthest = 0.0;
  for (std::size_t k = 200; k < before.positions.size(); ++k)
    furthest =
        std::max(furthest, distance(before.positions[k], nodes.positions[nodes.of_joint[k]]));
  EXPECT_LT(furthest, 12.4);  // half of the diagonal of a cell of 5.1 cbrt(22) Angstrom
  for (std::size_t k = 1; k < nodes.chain.size(); ++k)
    EXPECT_EQ(nodes.chain[k] != nodes.chain[k - 1], nodes.chain[k] != 0);
}

DenseMatrix distances_on_a_line(const std::vector<double>& x) {
  DenseMatrix d(x.size(), x.size());
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t j = 0; j < x.size(); ++j) d(i, j) = std::abs(x[i] - x[j]);
  return d;
}

/// By hand: {0, 1} at 1, {10, 12} at 2, {20} joins the latter at 9, all at (10 + 12 + 20 + 9 + 11 +
/// 19) / 6.
TEST(AverageLinkage, CutsAsByHand) {
  const AverageLinkage tree(distances_on_a_line({10.0, 0.0, 20.0, 1.0, 12.0}));
  using Cut = std::vector<std::uint32_t>;
  EXPECT_EQ(tree.cut(1), (Cut{0, 0, 0, 0, 0}));
  EXPECT_EQ(tree.cut(2), (Cut{0, 1, 0, 1, 0}));
  EXPECT_EQ(tree.cut(3), (Cut{0, 1, 2, 1, 0}));
  EXPECT_EQ(tree.cut(4), (Cut{0, 1, 2, 1, 3}));
  EXPECT_EQ(tree.cut(5), (Cut{0, 1, 2, 3, 4}));
}

/// Two nodes that move apart by 0.3 and 0.4 in two modes, and one at right angles to the line.
TEST(ChangesOfDistances, AddUpOverModes) {
  const std::vector<Vec3> x{{0, 0, 0}, {2, 0, 0}};
  DenseMatrix modes(3, 6);
  modes(0, 3) = 0.3;
  modes(1, 0) = -0.4;
  modes(2, 4) = 9.0;
  const std::vector<double> variances{1.0, 1.0, 1.0};
  EXPECT_NEAR(changes_of_distances(x, modes, variances)(0, 1), 0.5, 1e-15);
  const std::vector<double> doubled{4.0, 4.0, 1.0};
  EXPECT_NEAR(changes_of_distances(x, modes, doubled)(1, 0), 1.0, 1e-15);
}

}  // namespace pliant::elastic_network_test
