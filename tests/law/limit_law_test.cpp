// SPDX-License-Identifier: MIT
// What must hold of limits and sterics for every technique that knows them.
#include <rapidcheck/gtest.h>

#include "law/technique_cases.hpp"
#include "pliant/framework/measures/neighbour_list.hpp"
#include "pliant/resolve/auto.hpp"
#include "pliant/resolve/sweeps/limit_sweep.hpp"
#include "pliant/resolve/walkers.hpp"
#include "support/test.hpp"

namespace pliant::limit_law_test {

using test::TechniqueLaw;

/// Pairs up to `bonds` bars apart, by powers of the adjacency matrix.
std::vector<std::vector<bool>> within_bars(const Framework& framework, int bonds) {
  const std::size_t n = framework.joint_count();
  std::vector<std::vector<bool>> reached(n, std::vector<bool>(n, false));
  for (std::size_t i = 0; i < n; ++i) reached[i][i] = true;
  for (int round = 0; round < bonds; ++round) {
    const auto before = reached;
    for (std::size_t i = 0; i < n; ++i)
      for (const Bar bar : framework.bars()) {
        if (before[i][bar.a]) reached[i][bar.b] = true;
        if (before[i][bar.b]) reached[i][bar.a] = true;
      }
  }
  return reached;
}

/// Every pair, however far: the measure that is not the library's.
double largest_overlap(const Framework& framework, std::span<const Vec3> x) {
  const Sterics& sterics = *framework.sterics();
  const auto excluded = within_bars(framework, sterics.excluded_bonds);
  double largest = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t j = i + 1; j < x.size(); ++j)
      if (!excluded[i][j])
        largest = std::max(largest,
                           sterics.least[sterics.kinds[i] * sterics.kind_count + sterics.kinds[j]] -
                               distance(x[i], x[j]));
  return largest;
}

void expect_all_held(const Framework& framework, std::span<const Vec3> x) {
  for (std::size_t k = 0; k < framework.bar_count(); ++k) {
    const Bar bar = framework.bars()[k];
    const double rest = framework.rest_lengths()[k];
    EXPECT_LE(std::abs(distance(x[bar.a], x[bar.b]) - rest), 1e-6 * rest);
  }
  for (const Limit& limit : framework.limits()) {
    EXPECT_GE(distance(x[limit.a], x[limit.b]), limit.least - 1e-2);
    EXPECT_LE(distance(x[limit.a], x[limit.b]), limit.most + 1e-2);
  }
  if (framework.sterics() != nullptr) {
    EXPECT_LE(largest_overlap(framework, x), 0.1);
  }
}

/// Chains that fold back onto each other: bars and overlaps together.
Framework crowded_chains(double least) {
  FrameworkParts parts{.joint_count = 60};
  for (Joint k = 0; k + 1 < 60; ++k)
    if (k % 10 != 9) parts.bars.push_back({k, k + 1}), parts.rest_lengths.push_back(1.0);
  parts.sterics = test::spheres(60, least, 2);
  parts.limits = {{.a = 0, .b = 19, .least = 2.0, .most = 8.0}};
  return Framework(std::move(parts));
}

/// Side by side, nearer than the chains may be, and bent at random.
std::vector<Vec3> crowded_positions(std::uint64_t seed) {
  RandomSequence draws({seed, Domain::generate});
  std::vector<Vec3> x;
  for (int k = 0; k < 60; ++k) {
    const Vec3 place{double(k % 10), 0.7 * (k / 10 % 3), 0.7 * (k / 30)};
    x.push_back(place + 0.2 * draws.direction());
  }
  return x;
}

class LimitLaw : public TechniqueLaw {};

/// Equal shares converge; where one end of a bar takes all, bars and taut limits may chase each
/// other round and round, and the outcome says so.
TEST_P(LimitLaw, WhatConvergesHoldsAllByBruteForce) {
  each_case([](const Example& example, const Technique& technique) {
    if (example.framework.has_bars_only()) return;
    std::vector<Vec3> x = test::shake(example.framework, example.positions, 0.2);
    const ResolveSummary summary = resolve(example.framework, technique, x);
    EXPECT_TRUE(summary.converged() || technique.weighting != 0.5)
        << summary.brief(example.framework);
    if (summary.converged()) expect_all_held(example.framework, x);
  });
}

TEST_P(LimitLaw, CrowdedChainsHoldAllByBruteForce) {
  if (!GetParam().knows_limits) return;
  const Framework framework = crowded_chains(0.9);
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    std::vector<Vec3> x = crowded_positions(seed);
    const ResolveSummary summary = resolve(framework, plain(), x);
    EXPECT_TRUE(summary.converged()) << summary.brief(framework);
    expect_all_held(framework, x);
  }
}

/// A limit within its interval moves nothing: the same bits as without it.
TEST_P(LimitLaw, ALimitWithinItsIntervalIsAsNone) {
  if (!GetParam().knows_limits || GetParam().name == "auto") return;
  each_case([](const Example& example, const Technique& technique) {
    const Framework& framework = example.framework;
    if (framework.bar_count() == 0 || !framework.has_bars_only()) return;
    FrameworkParts parts = test::parts_of(framework);
    const Joint last = static_cast<Joint>(framework.joint_count() - 1);
    const auto beside = framework.neighbours(0);
    if (last == 0 || std::any_of(beside.begin(), beside.end(),
                                 [&](const Incidence& at) { return at.joint == last; }))
      return;
    parts.limits.push_back({.a = 0, .b = last, .least = 0.0, .most = 1e6});
    const ResolveOptions options{.max_sweeps = 200};
    std::vector<Vec3> x = test::shake(framework, example.positions, 0.1), y = x;
    const ResolveSummary without = resolve(framework, technique, x, options);
    const ResolveSummary with = resolve(Framework(std::move(parts)), technique, y, options);
    EXPECT_EQ(without.sweeps, with.sweeps);
    EXPECT_TRUE(test::same_bits(x, y));
  });
}

TEST_P(LimitLaw, ALimitSwitchedOffIsAsNone) {
  if (!GetParam().knows_limits) return;
  const Framework with = find_example("chain_5_with_tight_cable").framework;
  FrameworkParts parts = test::parts_of(with);
  parts.limits.push_back({.a = 1, .b = 3, .most = 0.3});
  const Framework both(std::move(parts));
  for (const Technique& technique : variants()) {
    std::vector<Vec3> x = test::shake(with, find_example("chain_5_with_tight_cable").positions,
                                      0.1),
                      y = x;
    Resolver resolver(both, technique);
    const std::vector<std::uint8_t> off{0, 1};
    resolver.set_limits_off(off);
    EXPECT_TRUE(resolver.resolve(x).converged());
    EXPECT_TRUE(resolve(with, technique, y).converged());
    EXPECT_TRUE(test::same_bits(x, y));
    resolver.set_limits_off({});
    EXPECT_GT(resolver.resolve(x).sweeps, 0);
  }
}

TEST_P(LimitLaw, PinnedJointsStay) {
  each_case([](const Example& example, const Technique& technique) {
    if (example.framework.has_bars_only()) return;
    const Framework framework = test::with_pinned(example.framework, {0, 2});
    std::vector<Vec3> x = test::shake(framework, example.positions, 0.2);
    const Vec3 first = x[0], third = x[2];
    resolve(framework, technique, x, {.max_sweeps = 500});
    EXPECT_EQ(x[0], first);
    EXPECT_EQ(x[2], third);
  });
}

/// One resolver for many walkers, alone or near, gives what a fresh one gives.
TEST_P(LimitLaw, ListsOfPairsLeaveNoTrace) {
  if (!GetParam().knows_limits) return;
  const Framework framework = crowded_chains(0.9);
  Resolver used(framework, plain());
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    std::vector<Vec3> x = crowded_positions(seed), y = x;
    used.resolve(x);
    resolve(framework, plain(), y);
    EXPECT_TRUE(test::same_bits(x, y));
    x[7] += Vec3{0.4, 0.2, 0.1};
    y = x;
    const ResolveSummary near = used.resolve_near(x, 7);
    Resolver(framework, plain()).resolve(y, 7);
    EXPECT_TRUE(test::same_bits(x, y));
    EXPECT_EQ(near.max_overlap, std::max(0.0, largest_overlap(framework, x)));
  }
}

TEST_P(LimitLaw, WhatKnowsNoLimitsSaysSo) {
  if (GetParam().knows_limits) return;
  const Framework& framework = find_example("spheres_27").framework;
  const std::string text = test::error_text<OptionError>([&] { Resolver(framework, plain()); });
  EXPECT_TRUE(text.starts_with("technique = " + std::string(GetParam().name) +
                               ": does not support limits; use one of auto, "))
      << text;
}

PLIANT_FOR_ALL_TECHNIQUES(LimitLaw);

/// However wide the skin, and whenever the list is made: the same bits.
TEST(Limits, NoSkinShowsInTheResult) {
  const Framework framework = crowded_chains(0.9);
  std::vector<Vec3> results[4];
  const double skins[4] = {1e-3, 0.3, 1.0, 20.0};
  for (int k = 0; k < 4; ++k) {
    results[k] = crowded_positions(5);
    LimitSweep sweep(framework, false, {}, skins[k]);
    sweep.begin({});
    for (int step = 0; step < 40; ++step) sweep.sweep(results[k], {});
    EXPECT_TRUE(test::same_bits(results[0], results[k])) << "skin " << skins[k];
  }
}

TEST(Limits, AutoTakesASweepAndSaysWhy) {
  const Choice choice = choose_technique(find_example("tensegrity_prism").framework);
  EXPECT_EQ(choice.technique.name, "anderson");
  EXPECT_EQ(choice.why, "limits beside the bars: sweeps know them, accelerated");
}

TEST(Limits, WalkersResolveAlone) {
  const Framework framework = crowded_chains(0.9);
  WalkerResolver resolver(framework, {.name = "bfs_cycle"});
  EXPECT_EQ(resolver.level(), "");
  std::vector<Vec3> x = crowded_positions(1), y = crowded_positions(2), alone = y;
  const WalkerPositions walkers[] = {{0, x}, {1, y}};
  ResolveSummary summaries[2];
  resolver.resolve(walkers, summaries);
  resolve(framework, {.name = "bfs_cycle"}, alone, {.walker = 1});
  EXPECT_TRUE(test::same_bits(y, alone));
}

/// Pairs by a cell list with a skin against all pairs, as the points wander.
RC_GTEST_PROP(NeighbourList, AreThoseOfBruteForce, ()) {
  const auto seed = *rc::gen::inRange<std::uint64_t>(0, 1000000);
  const double size = 0.1 * *rc::gen::inRange(5, 100);
  const double skin = 0.01 * *rc::gen::inRange(1, 300);
  RandomSequence draws({seed, Domain::generate});
  FrameworkParts parts{.joint_count = 30};
  auto sterics = std::make_shared<Sterics>(Sterics{.kind_count = 2, .least = {1.0, 0.7, 0.7, 0.4}});
  for (std::uint16_t k = 0; k < 30; ++k) sterics->kinds.push_back(k % 2);
  for (Joint k = 0; k + 1 < 10; ++k) parts.bars.push_back({k, k + 1});
  parts.rest_lengths.assign(9, 1.0);
  parts.sterics = std::move(sterics);
  const Framework framework(std::move(parts));
  std::vector<Vec3> x;
  for (int k = 0; k < 30; ++k) x.push_back(size * draws.uniform() * draws.direction());
  NeighbourList contacts(framework, skin);
  for (int step = 0; step < 10; ++step) {
    for (Vec3& at : x) at += 0.2 * draws.uniform() * draws.direction();
    const ResidualSummary found = measure(framework, x, {}, {}, &contacts);
    RC_ASSERT(found.max_overlap == std::max(0.0, largest_overlap(framework, x)));
  }
}

/// Of few joints that move far, of many, and of all, the pairs are listed anew in other ways.
RC_GTEST_PROP(NeighbourList, AreThereHoweverManyJointsMove, ()) {
  RandomSequence draws({*rc::gen::arbitrary<std::uint64_t>(), Domain::generate});
  const std::size_t joints = *rc::gen::element<std::size_t>(20, 400);
  const double share = *rc::gen::element(0.02, 0.4, 1.0);
  const Framework framework({.joint_count = joints, .sterics = test::spheres(joints, 0.8)});
  std::vector<Vec3> x;
  for (std::size_t k = 0; k < joints; ++k) x.push_back(6.0 * draws.uniform() * draws.direction());
  NeighbourList contacts(framework, 0.5);
  for (int step = 0; step < 8; ++step) {
    for (Vec3& at : x)
      if (draws.uniform() < share) at += 0.6 * draws.uniform() * draws.direction();
    const ResidualSummary found = measure(framework, x, {}, {}, &contacts);
    RC_ASSERT(found.max_overlap == std::max(0.0, largest_overlap(framework, x)));
    for (const NeighbourPair& pair : contacts.near())
      RC_ASSERT(pair.a < pair.b && pair.least == 0.8);
    RC_ASSERT(
        std::ranges::adjacent_find(contacts.near(), [](NeighbourPair one, NeighbourPair next) {
          return std::pair(one.a, one.b) >= std::pair(next.a, next.b);
        }) == contacts.near().end());
  }
}

}  // namespace pliant::limit_law_test
