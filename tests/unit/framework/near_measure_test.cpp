// SPDX-License-Identifier: MIT
#include "pliant/framework/measures/near_measure.hpp"

#include "pliant/base/random.hpp"
#include "pliant/framework/measures/kept_measure.hpp"
#include "pliant/framework/measures/neighbour_list.hpp"
#include "support/frameworks.hpp"
#include "support/test.hpp"

namespace pliant::near_measure_test {

constexpr std::size_t joints = 400;

/// A chain with bars, limits from each joint to the seventh after it, and spheres.
Framework framework_of_chain(std::span<const Vec3> places, std::shared_ptr<Sterics> sterics) {
  FrameworkParts parts{.joint_count = places.size(), .sterics = std::move(sterics)};
  for (Joint k = 0; k + 1 < places.size(); ++k) {
    parts.bars.push_back({k, k + 1});
    parts.rest_lengths.push_back(distance(places[k], places[k + 1]));
    if (k + 7 < places.size())
      parts.limits.push_back(
          {.a = k, .b = k + 7, .most = 1.05 * distance(places[k], places[k + 7])});
  }
  return Framework(parts);
}

/// Spheres of two kinds, and a pair with a distance of its own.
Framework made_framework(std::span<const Vec3> places) {
  auto sterics = test::spheres(places.size(), 0.0);
  sterics->kind_count = 2;
  sterics->least = {2.0, 2.4, 2.4, 3.0};
  for (Joint k = 0; k < places.size(); ++k) sterics->kinds[k] = std::uint16_t(k % 2);
  sterics->own.push_back({3, 90, 4.0});
  return framework_of_chain(places, sterics);
}

std::vector<Vec3> made_places(RandomSequence& draws, std::size_t count = joints, double size = 18) {
  std::vector<Vec3> places;
  for (std::size_t k = 0; k < count; ++k)
    places.push_back({size * draws.uniform(), size * draws.uniform(), size * draws.uniform()});
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

constexpr std::size_t chain_joints = 2000;

Framework framework_of_chain(std::span<const Vec3> places) {
  return framework_of_chain(places, test::spheres(places.size(), 2.0));
}

std::vector<Vec3> chain_places(RandomSequence& draws) {
  std::vector<Vec3> places{{0, 0, 0}};
  while (places.size() < chain_joints)
    places.push_back(places.back() + Vec3{1.2, 0, 0} + 0.6 * draws.direction());
  return places;
}

std::uint64_t bits(double x) { return std::bit_cast<std::uint64_t>(x); }

void expect_same(const ResidualSummary& one, const ResidualSummary& other) {
  EXPECT_EQ(one.within, other.within);
  EXPECT_EQ(one.finite, other.finite);
  EXPECT_EQ(one.worst_bar, other.worst_bar);
  EXPECT_EQ(one.worst_limit, other.worst_limit);
  EXPECT_EQ(one.worst_overlap, other.worst_overlap);
  EXPECT_EQ(bits(one.max_relative), bits(other.max_relative));
  EXPECT_EQ(bits(one.rms_relative), bits(other.rms_relative));
  EXPECT_EQ(bits(one.max_length), bits(other.max_length));
  EXPECT_EQ(bits(one.max_limit), bits(other.max_limit));
  EXPECT_EQ(bits(one.max_overlap), bits(other.max_overlap));
}

/// The same bits as a measure of all, whatever moved, how far and back again.
TEST(KeptMeasure, GivesWhatAMeasureOfAllGives) {
  RandomSequence draws({5, Domain::generate});
  const std::vector<Vec3> places = chain_places(draws);
  const Framework framework = framework_of_chain(places);
  const Tolerance tolerance{.relative = 1e-3, .limit = 0.1, .overlap = 0.2};
  KeptMeasure kept(framework, tolerance);
  std::vector<Vec3> x = places;
  std::vector<std::uint8_t> off(framework.limits().size(), 0);
  for (int turn = 0; turn < 120; ++turn) {
    SCOPED_TRACE(turn);
    const std::size_t moved = turn % 10 == 9 ? chain_joints : draws.below(5);
    for (std::size_t k = 0; k < moved; ++k)
      x[draws.below(chain_joints)] += (turn % 3 == 0 ? 1.0 : 0.02) * draws.direction();
    if (turn % 7 == 3) off[draws.below(off.size())] ^= 1;
    if (turn % 11 == 5) x = places;
    if (turn % 13 == 6) kept.measure_bars_and_limits(x, off);
    expect_same(kept.measure(x, off), measure(framework, x, tolerance, off));
  }
}

TEST(KeptMeasure, TellsOfLengthsThatAreNotFiniteAndForgetsThem) {
  RandomSequence draws({6, Domain::generate});
  const std::vector<Vec3> places = chain_places(draws);
  const Framework framework = framework_of_chain(places);
  KeptMeasure kept(framework, {});
  for (double bad : {std::numeric_limits<double>::quiet_NaN(), 1e301, 1e160}) {
    std::vector<Vec3> x = places;
    x[1234].y = bad;
    EXPECT_FALSE(kept.measure(x).finite);
    EXPECT_FALSE(kept.measure(x).within);
    EXPECT_EQ(kept.measure(x).worst_bar, measure(framework, x).worst_bar);
    expect_same(kept.measure(places), measure(framework, places));
  }
}

/// One joint of 2000: some blocks of bars, limits and near pairs, not all of them.
TEST(KeptMeasure, LooksAtWhatHasMovedAlone) {
  RandomSequence draws({7, Domain::generate});
  std::vector<Vec3> x = chain_places(draws);
  const Framework framework = framework_of_chain(x);
  KeptMeasure kept(framework, {});
  kept.measure(x);
  const std::int64_t all = kept.visits();
  EXPECT_GE(all, std::int64_t(framework.bar_count() + framework.limits().size()));
  kept.measure(x);
  EXPECT_EQ(kept.visits(), all);
  x[700] += Vec3{0.01, 0, 0};
  kept.measure(x);
  EXPECT_GT(kept.visits(), all);
  EXPECT_LE(kept.visits() - all, 6 * std::int64_t(MovedPairs::pairs_each));
}

constexpr std::size_t listed_joints = 300;

/// Joints of three kinds, one of which touches nothing of its own kind; a chain of bonds; a unit;
/// distances of their own that are longer and shorter than the table's, or none.
Sterics made_sterics(RandomSequence& draws) {
  Sterics sterics;
  sterics.kind_count = 3;
  sterics.least = {3.0, 2.5, 2.0, 2.5, 3.4, 1.5, 2.0, 1.5, 0.0};
  sterics.excluded_bonds = 2;
  sterics.units.assign(listed_joints, no_unit);
  for (std::uint32_t k = 0; k < listed_joints; ++k) {
    sterics.kinds.push_back(std::uint16_t(draws.below(3)));
    if (k > 0) sterics.bonds.emplace_back(k - 1, k);
    if (k >= 50 && k < 80) sterics.units[k] = 0;
  }
  for (std::uint32_t k = 0; k + 7 < listed_joints; k += 5)
    sterics.own.push_back({k + 7, k, k % 3 == 0 ? 3.9 : k % 3 == 1 ? 0.5 : 0.0});
  return sterics;
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
  const Framework framework({.joint_count = listed_joints, .sterics = sterics});
  NeighbourList contacts(framework, 0.8);
  for (int round = 0; round < 3; ++round) {
    const std::vector<Vec3> points = made_places(draws, listed_joints, 14);
    ASSERT_TRUE(contacts.update(points));
    std::vector<NeighbourPair> expected;
    for (std::uint32_t a = 0; a < listed_joints; ++a)
      for (std::uint32_t b = a + 1; b < listed_joints; ++b)
        if (const double least = least_of(*sterics, a, b);
            least > 0.0 && distance(points[a], points[b]) <= least + 0.8)
          expected.push_back({a, b, least});
    EXPECT_GT(expected.size(), 100U);
    EXPECT_TRUE(std::ranges::equal(contacts.near(), expected));
  }
  EXPECT_EQ(contacts.lists_made(), 3);
}

}  // namespace pliant::near_measure_test
