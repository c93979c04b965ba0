// SPDX-License-Identifier: MIT
#include "pliant/resolve/techniques.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "pliant/lab/examples/examples.hpp"
#include "pliant/resolve/method/shares.hpp"
#include "pliant/resolve/resolve.hpp"
#include "support/error_text.hpp"
#include "support/frameworks.hpp"

namespace pliant {
namespace techniques_test {

TEST(Techniques, HoldEveryOrderingAndNamesOfTheirOwn) {
  std::set<std::string_view> names;
  for (const TechniqueEntry& row : techniques()) {
    EXPECT_TRUE(names.insert(row.name).second) << row.name;
    EXPECT_FALSE(row.summary.empty());
    EXPECT_NE(row.make, nullptr);
    EXPECT_EQ(&find_technique(row.name), &row);
  }
  for (const OrderingEntry& row : orderings()) {
    EXPECT_EQ(find_technique(row.name).forests_only, row.forests_only);
    EXPECT_TRUE(find_technique(row.name).has_weighting);
  }
}

TEST(CheckTechnique, RefusesUnknownNamesAndWeightings) {
  const auto refusal = [](const Technique& technique) {
    return test::error_text<OptionError>([&] { check(technique); });
  };
  EXPECT_THROW(check(Technique{"shuffle"}), OptionError);
  EXPECT_EQ(refusal({"random", -0.1}), "weighting = -0.1: must be from 0 to 1");
  EXPECT_EQ(refusal({"random", 1.0000001}), "weighting = 1.0000001: must be from 0 to 1");
  EXPECT_EQ(refusal({"random", std::nan("")}), "weighting = nan: must be from 0 to 1");
  for (double weighting : {0.0, 0.3, 1.0}) EXPECT_NO_THROW(check(Technique{"random", weighting}));
}

TEST(CheckTechnique, RefusesWhatLeavesBarsOut) {
  EXPECT_EQ(
      test::error_text<OptionError>([] { check(Technique{"bfs_tree"}, framework_of(grid(2, 2))); }),
      "technique = bfs_tree: is for trees only, but the framework has 4 independent cycles");
  EXPECT_NO_THROW(check(Technique{"bfs_tree"}, framework_of(star(3))));
  EXPECT_NO_THROW(check(Technique{"bfs_cycle"}, framework_of(grid(2, 2))));
}

TEST(CheckTechnique, TakesAnOrderingForInputAlone) {
  const Framework framework = framework_of(ring(3));
  const auto refusal = [&](std::string name, Ordering ordering) {
    Technique technique{std::move(name)};
    technique.ordering = std::make_shared<Ordering>(std::move(ordering));
    return test::error_text<OptionError>([&] { check(technique, framework); });
  };
  const Ordering whole{{2, 0, true}, {0, 1, true}, {1, 2, true}};
  EXPECT_EQ(refusal("bfs_cycle", whole),
            "ordering: goes with the technique input, not with bfs_cycle");
  EXPECT_EQ(refusal("input", {whole[0], whole[1]}), "ordering: bar 1 - 2 is missing");
  Technique technique{"input"};
  technique.ordering = std::make_shared<Ordering>(whole);
  EXPECT_NO_THROW(check(technique, framework));
}

/// A technique's ordering, stated bar by bar, resolves as the technique does.
TEST(GivenOrdering, ResolvesAsTheTechniqueThatItWasTakenFrom) {
  const Example& example = find_example("thesis_figure_5_2");
  OrderScratch scratch;
  Ordering ordering;
  find_ordering("dfs_cycle").order({.framework = example.framework, .root = 2}, scratch, ordering);
  Technique given{"input", 0.75};
  given.ordering = std::make_shared<Ordering>(ordering);
  std::vector<Vec3> one = example.positions, two;
  one[2] += Vec3{0.3, 0.2, -0.1};
  two = one;
  const ResolveSummary first = resolve(example.framework, {"dfs_cycle", 0.75}, one, {}, 2);
  const ResolveSummary second = resolve(example.framework, given, two);
  EXPECT_TRUE(first.converged());
  EXPECT_EQ(first.sweeps, second.sweeps);
  EXPECT_TRUE(test::same_bits(one, two));
}

/// Joints 0 (12 u), 1 (1 u) and 2, pinned or not.
std::pair<double, double> shares_of(double weighting, bool mass_weighted, OrderedBar visit,
                                    std::vector<Joint> pinned = {}) {
  FrameworkParts parts;
  parts.joint_count = 3;
  parts.bars = {{0, 1}, {1, 2}};
  parts.rest_lengths = {1, 1};
  parts.masses = {12, 1, 16};
  parts.pinned = std::move(pinned);
  return shares({"input", weighting, mass_weighted}, visit, Framework(std::move(parts)));
}

using Shares = std::pair<double, double>;

TEST(Shares, FollowTheWeightingOnTreeBarsOnly) {
  EXPECT_EQ(shares_of(0.75, false, {0, 0, true}), (Shares{0.25, 0.75}));
  EXPECT_EQ(shares_of(0.75, false, {0, 1, true}), (Shares{0.25, 0.75}));
  EXPECT_EQ(shares_of(1.0, false, {0, 0, true}), (Shares{0.0, 1.0}));
  EXPECT_EQ(shares_of(1.0, false, {0, 0, false}), (Shares{0.5, 0.5}));
}

TEST(Shares, AreMultipliedByInverseMasses) {
  const auto [near, far] = shares_of(0.5, true, {0, 0, true});
  EXPECT_NEAR(near, 1.0 / 13.0, 1e-16);
  EXPECT_NEAR(far, 12.0 / 13.0, 1e-15);
  EXPECT_EQ(shares_of(1.0, true, {0, 0, true}), (Shares{0.0, 1.0}));
  EXPECT_EQ(shares_of(0.0, true, {0, 0, true}), (Shares{1.0, 0.0}));
}

TEST(Shares, OfPinnedJointsGoToTheOther) {
  for (double weighting : {0.0, 0.5, 1.0}) {
    for (bool mass_weighted : {false, true}) {
      EXPECT_EQ(shares_of(weighting, mass_weighted, {0, 0, true}, {0}), (Shares{0.0, 1.0}));
      EXPECT_EQ(shares_of(weighting, mass_weighted, {0, 0, true}, {1}), (Shares{1.0, 0.0}));
      EXPECT_EQ(shares_of(weighting, mass_weighted, {0, 1, true}, {0, 1}), (Shares{0.0, 0.0}));
    }
  }
}

/// The least and the largest mass in one bar: still shares, no 0/0.
TEST(Shares, StayFiniteAtTheEndsOfTheRangeOfMasses) {
  for (const auto& [one, other] : {std::pair{1e-150, 1e150}, {1e-150, 1e-150}, {1e150, 1e150}}) {
    FrameworkParts parts;
    parts.joint_count = 2;
    parts.bars = {{0, 1}};
    parts.rest_lengths = {1};
    parts.masses = {one, other};
    const auto [near, far] =
        shares({"input", 0.5, true}, {0, 0, true}, Framework(std::move(parts)));
    EXPECT_NEAR(near + far, 1.0, 1e-15);
  }
}

}  // namespace techniques_test
}  // namespace pliant
