// SPDX-License-Identifier: MIT
#include "pliant/framework/measures/kept_measure.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <limits>

#include "pliant/base/random.hpp"

namespace pliant::kept_measure_test {

constexpr std::size_t joints = 2000;

/// A chain with bars, limits from each joint to the seventh after it, and spheres.
Framework framework_of_chain(std::span<const Vec3> places) {
  FrameworkParts parts;
  parts.joint_count = places.size();
  auto sterics = std::make_shared<Sterics>();
  sterics->kind_count = 1;
  sterics->kinds.assign(places.size(), 0);
  sterics->least = {2.0};
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
  std::vector<Vec3> places{{0, 0, 0}};
  while (places.size() < joints)
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
  const std::vector<Vec3> places = made_places(draws);
  const Framework framework = framework_of_chain(places);
  const Tolerance tolerance{.relative = 1e-3, .limit = 0.1, .overlap = 0.2};
  KeptMeasure kept(framework, tolerance);
  std::vector<Vec3> x = places;
  std::vector<std::uint8_t> off(framework.limits().size(), 0);
  for (int turn = 0; turn < 120; ++turn) {
    SCOPED_TRACE(turn);
    const std::size_t moved = turn % 10 == 9 ? joints : draws.below(5);
    for (std::size_t k = 0; k < moved; ++k)
      x[draws.below(joints)] += (turn % 3 == 0 ? 1.0 : 0.02) * draws.direction();
    if (turn % 7 == 3) off[draws.below(off.size())] ^= 1;
    if (turn % 11 == 5) x = places;
    if (turn % 13 == 6) kept.measure_bars_and_limits(x, off);
    expect_same(kept.measure(x, off), measure(framework, x, tolerance, off));
  }
}

TEST(KeptMeasure, TellsOfLengthsThatAreNotFiniteAndForgetsThem) {
  RandomSequence draws({6, Domain::generate});
  const std::vector<Vec3> places = made_places(draws);
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
  std::vector<Vec3> x = made_places(draws);
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

}  // namespace pliant::kept_measure_test
