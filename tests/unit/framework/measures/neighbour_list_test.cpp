// SPDX-License-Identifier: MIT
#include "pliant/framework/measures/neighbour_list.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "pliant/base/random.hpp"

namespace pliant::neighbour_list_test {

constexpr std::size_t joints = 300;

/// Joints of three kinds, one of which touches nothing of its own kind; a chain of bonds; a unit;
/// distances of their own that are longer and shorter than the table's, or none.
Sterics made_sterics(RandomSequence& draws) {
  Sterics sterics;
  sterics.kind_count = 3;
  sterics.least = {3.0, 2.5, 2.0, 2.5, 3.4, 1.5, 2.0, 1.5, 0.0};
  sterics.excluded_bonds = 2;
  sterics.units.assign(joints, no_unit);
  for (std::uint32_t k = 0; k < joints; ++k) {
    sterics.kinds.push_back(std::uint16_t(draws.below(3)));
    if (k > 0) sterics.bonds.emplace_back(k - 1, k);
    if (k >= 50 && k < 80) sterics.units[k] = 0;
  }
  for (std::uint32_t k = 0; k + 7 < joints; k += 5)
    sterics.own.push_back({k + 7, k, k % 3 == 0 ? 3.9 : k % 3 == 1 ? 0.5 : 0.0});
  return sterics;
}

std::vector<Vec3> made_points(RandomSequence& draws) {
  std::vector<Vec3> points;
  for (std::size_t k = 0; k < joints; ++k)
    points.push_back({14.0 * draws.uniform(), 14.0 * draws.uniform(), 14.0 * draws.uniform()});
  return points;
}

/// The least distance of a < b by the definition of Sterics.
double least_of(const Sterics& sterics, std::uint32_t a, std::uint32_t b) {
  for (const OwnDistance& own : sterics.own)
    if (std::min(own.a, own.b) == a && std::max(own.a, own.b) == b) return own.least;
  if (sterics.units[a] == 0 && sterics.units[b] == 0) return 0.0;
  if (b - a <= std::uint32_t(sterics.excluded_bonds)) return 0.0;
  return sterics.of_kinds(a, b);
}

TEST(NeighbourList, AreAllPairsThatMayTouchAndNoOthersInOrder) {
  RandomSequence draws({.seed = 3});
  const auto sterics = std::make_shared<const Sterics>(made_sterics(draws));
  const Framework framework({.joint_count = joints, .sterics = sterics});
  NeighbourList contacts(framework, 0.8);
  for (int round = 0; round < 3; ++round) {
    const std::vector<Vec3> points = made_points(draws);
    ASSERT_TRUE(contacts.update(points));
    std::vector<NeighbourPair> expected;
    for (std::uint32_t a = 0; a < joints; ++a)
      for (std::uint32_t b = a + 1; b < joints; ++b)
        if (const double least = least_of(*sterics, a, b);
            least > 0.0 && distance(points[a], points[b]) <= least + 0.8)
          expected.push_back({a, b, least});
    EXPECT_GT(expected.size(), 100U);
    EXPECT_TRUE(std::ranges::equal(contacts.near(), expected));
  }
  EXPECT_EQ(contacts.lists_made(), 3);
}

}  // namespace pliant::neighbour_list_test
