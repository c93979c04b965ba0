// SPDX-License-Identifier: MIT
#include "pliant/framework/measures/near_measure.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <set>

#include "pliant/base/random.hpp"

namespace pliant::near_measure_test {

constexpr std::size_t joints = 400;

/// A chain with bars, limits, spheres of two kinds, and a pair with a distance of its own.
Framework made_framework(std::span<const Vec3> places) {
  FrameworkParts parts;
  parts.joint_count = places.size();
  auto sterics = std::make_shared<Sterics>();
  sterics->kind_count = 2;
  sterics->least = {2.0, 2.4, 2.4, 3.0};
  for (Joint k = 0; k < places.size(); ++k) sterics->kinds.push_back(std::uint16_t(k % 2));
  sterics->own.push_back({3, 90, 4.0});
  parts.sterics = sterics;
  for (Joint k = 0; k + 1 < places.size(); ++k) {
    parts.bars.push_back({k, k + 1});
    parts.rest_lengths.push_back(distance(places[k], places[k + 1]));
    if (k + 7 < places.size())
      parts.limits.push_back({k, k + 7, 0.0, 1.05 * distance(places[k], places[k + 7]),
                              LimitKind::given, 0.0, no_limit_group});
  }
  return Framework(parts);
}

std::vector<Vec3> made_places(RandomSequence& draws) {
  std::vector<Vec3> places;
  for (std::size_t k = 0; k < joints; ++k)
    places.push_back({18 * draws.uniform(), 18 * draws.uniform(), 18 * draws.uniform()});
  return places;
}

const auto all_anew = [](Joint) { return false; };

using Ends = std::pair<Joint, Joint>;

std::set<Ends> overlapping(const Framework& framework, std::span<const Vec3> places) {
  const LeastDistances rules(framework);
  std::set<Ends> found;
  for (Joint a = 0; a < places.size(); ++a)
    for (Joint b = a + 1; b < places.size(); ++b)
      if (distance(places[a], places[b]) < rules.of(a, b)) found.insert({a, b});
  return found;
}

std::set<Ends> listed(JointNeighbours& near, std::span<const Vec3> places) {
  std::set<Ends> found;
  for (Joint a = 0; a < places.size(); ++a)
    for (const NearJoint& other : near.near(a))
      if (distance(places[a], places[other.joint]) < other.least)
        found.insert({std::min(a, other.joint), std::max(a, other.joint)});
  return found;
}

/// All pairs that overlap, whichever joints have moved and how far, as by trying all pairs.
TEST(JointNeighbours, FindAllOverlapsAfterMovesOfSome) {
  RandomSequence draws({11, Domain::generate});
  std::vector<Vec3> places = made_places(draws);
  const Framework framework = made_framework(places);
  JointNeighbours near(framework);
  ASSERT_TRUE(near.start(places));
  EXPECT_GT(overlapping(framework, places).size(), 50u);
  for (int round = 0; round < 40; ++round) {
    EXPECT_EQ(listed(near, places), overlapping(framework, places)) << round;
    for (int k = 0; k < 30; ++k) {
      const auto joint = static_cast<Joint>(draws.below(joints));
      places[joint] += (k == 0 ? 9.0 : 0.4) * draws.direction();
      near.look(joint, places[joint]);
    }
  }
}

TEST(JointNeighbours, ListJustThePairsWithinTheirReach) {
  RandomSequence draws({12, Domain::generate});
  const std::vector<Vec3> places = made_places(draws);
  const Framework framework = made_framework(places);
  JointNeighbours near(framework, 0.5);
  ASSERT_TRUE(near.start(places));
  const LeastDistances rules(framework);
  for (Joint a = 0; a < joints; ++a)
    for (const NearJoint& other : near.near(a)) {
      EXPECT_DOUBLE_EQ(other.least, rules.of(std::min(a, other.joint), std::max(a, other.joint)));
      EXPECT_LE(distance(places[a], places[other.joint]), other.least + 0.5 + 1e-6);
    }
}

TEST(JointNeighbours, RefusePositionsThatNoCellHolds) {
  RandomSequence draws({13, Domain::generate});
  std::vector<Vec3> places = made_places(draws);
  const Framework framework = made_framework(places);
  JointNeighbours near(framework);
  places[7].y = 1e200;
  EXPECT_FALSE(near.start(places));
  places[7].y = std::nan("");
  EXPECT_FALSE(near.start(places));
}

/// What is measured at all joints is what a measure of all finds.
TEST(NearMeasure, AtAllJointsIsTheMeasureOfAll) {
  RandomSequence draws({14, Domain::generate});
  const std::vector<Vec3> drawn = made_places(draws);
  const Framework framework = made_framework(drawn);
  std::vector<Vec3> places = drawn;
  NearMeasure near(framework, {});
  for (int round = 0; round < 5; ++round) {
    std::vector<Joint> moved;
    for (int k = 0; k < 12; ++k) {
      moved.push_back(static_cast<Joint>(draws.below(joints)));
      places[moved.back()] += draws.direction();
    }
    ASSERT_TRUE(near.begin(places, moved, round > 0));
    ResidualSummary found;
    for (Joint joint = 0; joint < joints; ++joint)
      near.measure_at(places, joint, {}, found, all_anew);
    const ResidualSummary all = measure(framework, places);
    EXPECT_EQ(found.within, all.within);
    EXPECT_DOUBLE_EQ(found.max_relative, all.max_relative);
    EXPECT_DOUBLE_EQ(found.max_limit, all.max_limit);
    EXPECT_DOUBLE_EQ(found.max_overlap, all.max_overlap);
    EXPECT_EQ(found.worst_overlap, all.worst_overlap);
    EXPECT_EQ(found.worst_limit, all.worst_limit);
    EXPECT_EQ(found.worst_bar, all.worst_bar);
  }
}

TEST(NearMeasure, LimitsThatAreOffDoNotCount) {
  RandomSequence draws({15, Domain::generate});
  const std::vector<Vec3> drawn = made_places(draws);
  const Framework framework = made_framework(drawn);
  std::vector<Vec3> places = drawn;
  places[20] += Vec3{5, 0, 0};
  NearMeasure near(framework, {});
  ASSERT_TRUE(near.begin(places, {}, false));
  const std::vector<std::uint8_t> off(framework.limits().size(), 1);
  ResidualSummary on_found, off_found;
  near.measure_at(places, 20, {}, on_found, all_anew);
  near.measure_at(places, 20, off, off_found, all_anew);
  EXPECT_GT(on_found.max_limit, 0.1);
  EXPECT_EQ(off_found.max_limit, 0.0);
}

}  // namespace pliant::near_measure_test
