// SPDX-License-Identifier: MIT
#include "pliant/sample/network/b_factors.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace pliant {
namespace b_factors_test {

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

TEST(BFactors, HaveTheMeanOne) { EXPECT_NEAR(mean_of(relative_b_factors(helix(40))), 1.0, 1e-12); }

TEST(BFactors, AreLargestAtTheEndsOfAHelixAndAlikeAtBoth) {
  const std::vector<double> values = relative_b_factors(helix(40));
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

}  // namespace b_factors_test
}  // namespace pliant
