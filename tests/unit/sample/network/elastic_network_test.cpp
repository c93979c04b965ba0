// SPDX-License-Identifier: MIT
#include "pliant/sample/network/elastic_network.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "pliant/base/error.hpp"
#include "support/error_text.hpp"

namespace pliant {
namespace elastic_network_test {

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
  const auto text = [](const NetworkNodes& nodes, std::size_t joints) {
    return test::error_text<Error>([&] { check(nodes, joints); });
  };
  EXPECT_EQ(text(good, 2), "network: nodes of 3 joints for 2");
  NetworkNodes bad = good;
  bad.positions.clear();
  EXPECT_EQ(text(bad, 3), "network: 0 nodes; it needs 2 or more");
  bad = good;
  bad.chain.pop_back();
  EXPECT_EQ(text(bad, 3), "network: 1 chains for 2 nodes");
  bad = good;
  bad.of_joint[1] = 2;
  EXPECT_EQ(text(bad, 3), "network: node 2 of 2 does not exist");
  bad = good;
  bad.positions[1].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(text(bad, 3), "network: the position of node 1 is not finite");
}

}  // namespace elastic_network_test
}  // namespace pliant
