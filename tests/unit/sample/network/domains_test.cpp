// SPDX-License-Identifier: MIT
#include "pliant/sample/network/domains.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace pliant {
namespace domains_test {

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

}  // namespace domains_test
}  // namespace pliant
