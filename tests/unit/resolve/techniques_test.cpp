// SPDX-License-Identifier: MIT
#include "pliant/resolve/techniques.hpp"

#include "pliant/lab/examples/examples.hpp"
#include "pliant/resolve/auto.hpp"
#include "pliant/resolve/method/shares.hpp"
#include "pliant/resolve/resolve.hpp"
#include "support/frameworks.hpp"
#include "support/test.hpp"

namespace pliant::techniques_test {

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
  EXPECT_THROW(check(Technique{"shuffle"}), OptionError);
  for (const auto& [weighting, text] :
       {std::pair{-0.1, "-0.1"}, {1.0000001, "1.0000001"}, {std::nan(""), "nan"}})
    EXPECT_ERROR(OptionError, "weighting = " + std::string(text) + ": must be from 0 to 1",
                 check(Technique{"random", weighting}));
  for (double weighting : {0.0, 0.3, 1.0}) EXPECT_NO_THROW(check(Technique{"random", weighting}));
}

TEST(CheckTechnique, RefusesWhatLeavesBarsOut) {
  EXPECT_ERROR(
      OptionError,
      "technique = bfs_tree: is for trees only, but the framework has 4 independent cycles",
      check(Technique{"bfs_tree"}, framework_of(grid(2, 2))));
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
  return shares({"input", weighting, mass_weighted}, visit,
                Framework({.joint_count = 3,
                           .bars = {{0, 1}, {1, 2}},
                           .rest_lengths = {1, 1},
                           .masses = {12, 1, 16},
                           .pinned = std::move(pinned)}));
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
    const auto [near, far] = shares(
        {"input", 0.5, true}, {0, 0, true},
        Framework(
            {.joint_count = 2, .bars = {{0, 1}}, .rest_lengths = {1}, .masses = {one, other}}));
    EXPECT_NEAR(near + far, 1.0, 1e-15);
  }
}

std::string chosen(const Framework& framework) {
  return std::string(choose_technique(framework).technique.name);
}

TEST(Automatic, ChoosesByWhatTheBarsForm) {
  const Choice tree = choose_technique(framework_of(chain(5)));
  EXPECT_EQ(tree.technique.name, "blocks");
  EXPECT_EQ(tree.why, "the bars close no cycle: one outward pass makes them whole");
  const Choice hexagon = choose_technique(framework_of(ring(6)));
  EXPECT_EQ(hexagon.technique.name, "blocks");
  EXPECT_EQ(hexagon.why,
            "1 ring system, each by Newton's method, and 0 bridges in one outward pass");
  const Choice angles = choose_technique(framework_of(with_angles(shaken(chain(9), 0.2))));
  EXPECT_EQ(angles.technique.name, "units");
  EXPECT_EQ(angles.why, "most bars are in triangles: rigid units in one outward pass");
  EXPECT_EQ(chosen(framework_of(ring(3))), "blocks") << "quicker by Newton than as a unit";
  EXPECT_EQ(chosen(framework_of(complete(4))), "blocks");
  EXPECT_EQ(chosen(framework_of(complete(5))), "units");
  EXPECT_EQ(chosen(framework_of(complete(80))), "anderson");
  EXPECT_EQ(chosen(framework_of(star(500))), "blocks") << "a hub, but no cycle";
  EXPECT_EQ(chosen(framework_of(chain(1))), "blocks") << "no bar at all";
  Sketch with_ions = with_angles(shaken(chain(9), 0.2));
  for (int k = 0; k < 100; ++k) with_ions.positions.push_back({10.0 + k, 0, 0});
  EXPECT_EQ(chosen(framework_of(with_ions)), "units") << "joints without bars do not count";
  const Framework pinned = test::with_pinned(framework_of(ring(6)), {0, 3});
  EXPECT_EQ(chosen(pinned), "newton");
  EXPECT_TRUE(choose_technique(pinned, {"auto", 0.5, true}).technique.mass_weighted);
}

/// `moving` and, after it, `still`, all of whose joints are pinned.
Framework beside_pinned(const Sketch& moving, const Sketch& still) {
  Sketch both = moving;
  const auto first = static_cast<Joint>(moving.positions.size());
  for (Bar bar : still.bars) both.bars.push_back({bar.a + first, bar.b + first});
  both.positions.insert(both.positions.end(), still.positions.begin(), still.positions.end());
  std::vector<Joint> pinned(still.positions.size());
  std::iota(pinned.begin(), pinned.end(), first);
  return test::with_pinned(framework_of(both), pinned);
}

TEST(Automatic, ComponentsThatArePinnedAsAWholeChangeNothing) {
  for (const Sketch& moving : {shaken(chain(20), 0.2), ring(7), shaken(grid(3, 3), 0.1)}) {
    const Framework alone = framework_of(moving);
    for (const Sketch& still : {chain(4), ring(5), ring(3)}) {
      const Framework both = beside_pinned(moving, still);
      EXPECT_EQ(chosen(both), "blocks");
      std::vector<Vec3> x = test::shake(alone, moving.positions, 0.1), y = x;
      y.insert(y.end(), still.positions.begin(), still.positions.end());
      EXPECT_TRUE(resolve(alone, {}, x).converged());
      EXPECT_TRUE(resolve(both, {}, y).converged());
      EXPECT_LE(test::largest_difference(x, std::span(y).first(x.size())), 1e-12);
      EXPECT_TRUE(test::same_bits(still.positions, std::span(y).subspan(x.size())));
    }
  }
}

TEST(Automatic, PinsThatBindAComponentAreToldFromThoseThatDoNot) {
  const Framework two_rings = beside_pinned(ring(6), ring(6));
  std::vector<Joint> all(12);
  std::iota(all.begin(), all.end(), Joint{0});
  const std::pair<std::vector<Joint>, const char*> cases[] = {{{0, 6}, "blocks"},  // one in each
                                                              {{0, 3, 6}, "newton"},
                                                              {{0, 6, 7, 8, 9, 10, 11}, "blocks"},
                                                              {all, "blocks"}};  // nothing moves
  for (const auto& [pinned, name] : cases)
    EXPECT_EQ(chosen(test::with_pinned(two_rings, pinned)), name);
}

TEST(Automatic, DoesWhatTheChosenTechniqueDoes) {
  for (const Sketch& sketch :
       {shaken(chain(20), 0.2), ring(7), with_angles(shaken(chain(8), 0.2))}) {
    const Framework framework = framework_of(sketch);
    std::vector<Vec3> x = test::shake(framework, sketch.positions, 0.1), y = x;
    const ResolveSummary by_auto = resolve(framework, {}, x);
    const ResolveSummary by_name = resolve(framework, choose_technique(framework).technique, y);
    EXPECT_TRUE(by_auto.converged());
    EXPECT_EQ(by_auto.projections, by_name.projections);
    EXPECT_TRUE(test::same_bits(x, y));
    Resolver resolver(framework, {});
    x[3] += Vec3{0.01, 0.0, 0.02};
    EXPECT_TRUE(resolver.resolve_near(x, 3).converged());
  }
}

TEST(Automatic, NamesTheTechniqueUsed) {
  const Framework framework = framework_of(chain(5));
  EXPECT_EQ(technique_used(framework, {}).name, "blocks");
  EXPECT_EQ(technique_used(framework, {"random", 0.75}).name, "random");
  EXPECT_EQ(technique_used(framework, {"random", 0.75}).weighting, 0.75);
}

}  // namespace pliant::techniques_test
