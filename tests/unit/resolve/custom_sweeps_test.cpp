// SPDX-License-Identifier: MIT
// Sweeps that callers see and make: Technique::sweep, functions of theirs, and
// ResolveOptions::on_bar, which shows bars being repaired one by one.
#include "pliant/lab/examples/examples.hpp"
#include "pliant/order/ordering.hpp"
#include "pliant/resolve/method/project_bar.hpp"
#include "pliant/resolve/techniques.hpp"
#include "pliant/resolve/walkers.hpp"
#include "pliant/run/run.hpp"
#include "pliant/run/run_fields.hpp"
#include "support/frameworks.hpp"
#include "support/test.hpp"

namespace pliant::custom_sweeps_test {

Technique custom(CustomSweep sweep) {
  Technique technique{custom_technique};
  technique.sweep = std::move(sweep);
  return technique;
}

/// All bars in the order of the input, shared half and half: what `input` does.
Technique projecting(const Framework& framework) {
  return custom([&framework](std::span<Vec3> x, std::int64_t) {
    for (BarIndex bar = 0; bar < framework.bar_count(); ++bar) {
      const auto [a, b] = framework.bars()[bar];
      project_bar(x[a], x[b], framework.rest_lengths()[bar], 0.5, 0.5, [] {
        return Vec3{1, 0, 0};
      });
    }
  });
}

std::vector<Vec3> pushed(const Sketch& sketch) {
  std::vector<Vec3> x = sketch.positions;
  x[1] += Vec3{0.1, 0.2, 0.3};
  return x;
}

TEST(CustomSweeps, DoWhatTheSameTechniqueDoes) {
  for (const Sketch& sketch : {chain(7), ring(6), grid(3, 3)}) {
    const Framework framework = framework_of(sketch);
    std::vector<Vec3> ours = pushed(sketch), own = ours;
    const ResolveSummary expected = resolve(framework, {"input"}, ours);
    const ResolveSummary summary = resolve(framework, projecting(framework), own);
    EXPECT_TRUE(summary.converged());
    EXPECT_EQ(summary.sweeps, expected.sweeps);
    EXPECT_EQ(summary.projections, expected.projections);
    EXPECT_TRUE(test::same_bits(ours, own));
  }
}

TEST(CustomSweeps, AreCountedAndGivenUp) {
  const Framework framework = framework_of(chain(3));
  std::vector<Vec3> x = pushed(chain(3));
  const std::vector<Vec3> before = x;
  std::vector<std::int64_t> sweeps;
  const Technique idle =
      custom([&](std::span<Vec3>, std::int64_t sweep) { sweeps.push_back(sweep); });
  ResolveOptions options{.max_sweeps = 3};
  EXPECT_EQ(resolve(framework, idle, x, options).stop, Stop::max_sweeps);
  EXPECT_EQ(sweeps, (std::vector<std::int64_t>{0, 1, 2}));
  options.should_stop = [] { return true; };
  EXPECT_EQ(resolve(framework, idle, x, options).stop, Stop::stopped_by_caller);
  EXPECT_EQ(sweeps.size(), 4u);
  EXPECT_TRUE(test::same_bits(x, before));
}

TEST(CustomSweeps, WhatIsNotFiniteIsPutBack) {
  // The last joint has no bar.
  const Framework framework({.joint_count = 3, .bars = {{0, 1}}, .rest_lengths = {1.5}});
  for (Joint joint : {0, 2}) {
    std::vector<Vec3> x = {{0, 0, 0}, {0, 0, 2}, {3, 0, 0}};
    const std::vector<Vec3> before = x;
    const Technique wild = custom([joint](std::span<Vec3> positions, std::int64_t) {
      positions[joint].x = std::numeric_limits<double>::quiet_NaN();
    });
    EXPECT_EQ(resolve(framework, wild, x).stop, Stop::not_finite);
    EXPECT_TRUE(test::same_bits(x, before));
  }
}

TEST(CustomSweeps, WhatTheyThrowLeavesPositionsAsTheyWere) {
  const Framework framework = framework_of(chain(3));
  std::vector<Vec3> x = pushed(chain(3));
  const std::vector<Vec3> before = x;
  const Technique failing = custom([](std::span<Vec3> positions, std::int64_t) {
    positions[0].x += 1.0;
    throw std::logic_error("no");
  });
  EXPECT_THROW(resolve(framework, failing, x), std::logic_error);
  EXPECT_TRUE(test::same_bits(x, before));
}

TEST(CustomSweeps, LeavePinnedJointsWhereTheyAre) {
  const Framework framework(
      {.joint_count = 2, .bars = {{0, 1}}, .rest_lengths = {1.5}, .pinned = {0}});
  std::vector<Vec3> x = {{0, 0, 0}, {0, 0, 2}};
  EXPECT_TRUE(resolve(framework, projecting(framework), x).converged());
  EXPECT_EQ(x[0], Vec3());
}

/// Nine walkers that begin alike, resolved without lanes; their positions and summaries.
std::pair<std::vector<std::vector<Vec3>>, std::vector<ResolveSummary>> nine_resolved(
    const Framework& framework, const std::vector<Vec3>& start, const Technique& technique,
    const ResolveOptions& options = {}) {
  std::vector<std::vector<Vec3>> conformers(9, start);
  std::vector<WalkerPositions> walkers;
  for (std::uint64_t k = 0; k < 9; ++k) walkers.push_back({k, conformers[k]});
  std::vector<ResolveSummary> summaries(9);
  WalkerResolver resolver(framework, technique, options);
  EXPECT_EQ(resolver.level(), "");
  resolver.resolve(walkers, summaries, 1);
  return {conformers, summaries};
}

TEST(CustomSweeps, ResolveWalkersOneByOne) {
  const Framework framework = framework_of(ring(6));
  std::vector<Vec3> alone = pushed(ring(6));
  const auto conformers = nine_resolved(framework, alone, projecting(framework)).first;
  resolve(framework, projecting(framework), alone);
  for (const std::vector<Vec3>& x : conformers) EXPECT_TRUE(test::same_bits(x, alone));
}

TEST(CustomSweeps, RunAndAreRecorded) {
  const Sketch sketch = ring(6);
  const Framework framework = framework_of(sketch);
  RunOptions options{.technique = projecting(framework), .steps = 20};
  State own(sketch.positions), ours(sketch.positions);
  EXPECT_EQ(run(framework, own, options, {}).unconverged_steps, 0);
  const std::vector<NamedParameter> values = parameters_of(options, framework);
  for (const char* path : {"run/technique", "run/technique_used"})
    EXPECT_NE(std::find(values.begin(), values.end(), NamedParameter(path, std::string("custom"))),
              values.end());
  options.technique = {"input"};
  run(framework, ours, options, {});
  EXPECT_TRUE(test::same_bits(own.positions, ours.positions));
}

TEST(CustomSweeps, HaveANameOfTheirOwn) {
  Technique technique = custom([](std::span<Vec3>, std::int64_t) {});
  EXPECT_NO_THROW(check(technique));
  technique.name = "blocks";
  EXPECT_ERROR(OptionError, "sweep: goes with the technique custom, not with blocks",
               check(technique));
  EXPECT_THROW(check(Technique{custom_technique}), OptionError);
  for (const TechniqueEntry& row : techniques()) EXPECT_NE(row.name, custom_technique);
  const ResolveOptions options{.on_bar = [](const RepairedBar&) {}};
  const Framework framework = framework_of(chain(3));
  EXPECT_THROW(Resolver(framework, projecting(framework), options), OptionError);
}

/// Each visit is shown with the positions that it left, and watching changes nothing.
TEST(OnBar, ShowsEachVisitOfEveryOrdering) {
  const Sketch sketch = chain(7);
  const Framework framework = framework_of(sketch);
  for (const OrderingEntry& row : orderings()) {
    SCOPED_TRACE(row.name);
    std::vector<Vec3> watched = pushed(sketch), alone = watched, last;
    std::int64_t visits = 0;
    const ResolveOptions options{.on_bar = [&](const RepairedBar& repaired) {
      const Bar bar = framework.bars()[repaired.bar];
      EXPECT_EQ(std::minmax(bar.a, bar.b), std::minmax(repaired.near, repaired.far));
      for (Joint joint = 0; joint < last.size(); ++joint) {
        EXPECT_TRUE(joint == repaired.near || joint == repaired.far ||
                    last[joint] == repaired.positions[joint]);
      }
      last.assign(repaired.positions.begin(), repaired.positions.end());
      ++visits;
    }};
    const Technique technique{std::string(row.name)};
    const ResolveSummary summary = resolve(framework, technique, watched, options, 1);
    resolve(framework, technique, alone, {}, 1);
    EXPECT_EQ(visits, summary.projections);
    EXPECT_GT(visits, 0);
    EXPECT_TRUE(test::same_bits(watched, alone));
    EXPECT_TRUE(test::same_bits(watched, last));
  }
}

TEST(OnBar, IsRefusedByWhatDoesNotGoBarByBar) {
  const Framework framework = framework_of(chain(3));
  ResolveOptions options{.on_bar = [](const RepairedBar&) {}};
  for (const TechniqueEntry& row : techniques()) {
    const bool is_ordering =
        std::ranges::any_of(orderings(), [&](const auto& one) { return one.name == row.name; });
    const auto refusal = test::error_text<OptionError>(
        [&] { Resolver(framework, Technique{std::string(row.name)}, options); });
    EXPECT_EQ(refusal.empty(), is_ordering) << row.name;
  }
  EXPECT_ERROR(OptionError, "on_bar: technique blocks does not go bar by bar; orderings do",
               Resolver(framework, {"blocks"}, options));
}

TEST(OnBar, WalkersAreWatchedToo) {
  const Framework framework = framework_of(chain(7));
  std::int64_t visits = 0, projections = 0;
  const auto summaries = nine_resolved(framework, pushed(chain(7)), {"bfs_cycle"},
                                       {.on_bar = [&](const RepairedBar&) { ++visits; }})
                             .second;
  for (const ResolveSummary& summary : summaries) projections += summary.projections;
  EXPECT_EQ(visits, projections);
}

}  // namespace pliant::custom_sweeps_test
