// SPDX-License-Identifier: MIT
#include "pliant/resolve/resolve.hpp"

#include "pliant/lab/examples/examples.hpp"
#include "pliant/resolve/walkers.hpp"
#include "support/frameworks.hpp"
#include "support/test.hpp"

namespace pliant::resolve_test {

TEST(CheckResolveOptions, NamesOptionValueAndRange) {
  EXPECT_NO_THROW(check(ResolveOptions{}));
  const std::pair<const char*, ResolveOptions> cases[] = {
      {"tolerance = 0: must be positive and finite", {.tolerance = {.relative = 0.0}}},
      {"tolerance = inf: must be positive and finite", {.tolerance = {.relative = HUGE_VAL}}},
      {"tolerance_length = -0.5: must be positive and finite", {.tolerance = {.length = -0.5}}},
      {"tolerance_limit = 0: must be positive and finite", {.tolerance = {.limit = 0.0}}},
      {"tolerance_overlap = -1: must be positive and finite", {.tolerance = {.overlap = -1}}},
      {"max_sweeps = 0: must be from 1", {.max_sweeps = 0}}};
  for (const auto& [text, options] : cases) EXPECT_ERROR(OptionError, text, check(options));
}

TEST(Resolver, ChecksItsOptionsAtTheDoor) {
  const Framework framework = framework_of(ring(4));
  EXPECT_THROW(Resolver(framework, {"bfs_tree"}), OptionError);
  EXPECT_THROW(Resolver(framework, {"none"}), OptionError);
  EXPECT_THROW(Resolver(framework, {}, {.max_sweeps = 0}), OptionError);
}

TEST(Resolver, ChecksPositionsAndRoot) {
  const Framework framework = framework_of(ring(4));
  Resolver resolver(framework, {});
  std::vector<Vec3> x(3);
  EXPECT_ERROR(OptionError, "positions: 3 for 4 joints", resolver.resolve(x));
  x.resize(4);
  EXPECT_ERROR(OptionError, "root joint 4 of 4 does not exist", resolver.resolve(x, 4));
  const std::vector<Joint> joints = {0, 7};
  EXPECT_ERROR(OptionError, "disturbed joint 7 of 4 does not exist",
               resolver.resolve(x, {0, false, joints}));
}

TEST(Resolver, TellsWhichJointsMovedIfNotAny) {
  const Framework framework = framework_of(straight_chain(9));
  std::vector<Vec3> x = straight_chain(9).positions;
  x[4].y += 0.1;
  Resolver resolver(framework, {"blocks"});
  EXPECT_FALSE(resolver.moved()) << "nothing was resolved";
  resolver.resolve_near(x, 4);
  ASSERT_TRUE(resolver.moved());
  EXPECT_GT(resolver.moved()->size(), 0u);
  resolver.resolve_near(x, 4);
  EXPECT_EQ(resolver.moved()->size(), 0u) << "all is whole";
  resolver.resolve(x, 4);
  EXPECT_FALSE(resolver.moved());
  Resolver all(framework, {"bfs_cycle"});
  all.resolve_near(x, 4);
  EXPECT_FALSE(all.moved()) << "knows no such way";
}

TEST(Resolver, ResolvesNothing) {
  std::vector<Vec3> none;
  const ResolveSummary summary = resolve(Framework({}), {}, none);
  EXPECT_TRUE(summary.converged());
  EXPECT_EQ(summary.max_residual, 0.0);
  EXPECT_EQ(summary.brief(Framework({})), "converged: 0 sweeps, 0 projections");
}

TEST(ResolveSummary, ShowsThatNothingRan) {
  const ResolveSummary summary;
  EXPECT_FALSE(summary.converged());
  EXPECT_EQ(summary.sweeps, -1);
  EXPECT_EQ(summary.max_residual, -1.0);
}

TEST(ResolveSummary, BriefNamesTheWorstBar) {
  const Example& example = find_example("pinned_pair_wrong_distance");
  std::vector<Vec3> x = example.positions;
  const ResolveSummary summary = resolve(example.framework, {"input"}, x, {.max_sweeps = 5});
  EXPECT_EQ(summary.brief(example.framework),
            "max_sweeps: 5 sweeps, 5 projections, worst bar 0 - 1 off by 1 of its length");
}

/// The absolute tolerance is that of the thesis: a long bar may be off by as much as a short one.
TEST(Resolve, KeepsAToleranceInAngstrom) {
  const Framework framework(
      {.joint_count = 3, .bars = {{0, 1}, {1, 2}}, .rest_lengths = {1000.0, 1.0}});
  std::vector<Vec3> x{{0, 0, 0}, {1000.02, 0, 0}, {1000.02, 1, 0}};
  EXPECT_EQ(resolve(framework, {}, x, {.tolerance = {.relative = 1e-4}}).sweeps, 0);
  EXPECT_EQ(resolve(framework, {}, x, {.tolerance = {.length = 0.03}}).sweeps, 0);
  EXPECT_GT(resolve(framework, {}, x, {.tolerance = {.length = 0.01}}).sweeps, 0);
}

/// reverse: forwards, then backwards. After two sweeps of a chain the first bar is whole last.
TEST(Resolve, ReverseTechniquesTurnRound) {
  const Sketch sketch = straight_chain(4);
  const Framework framework = framework_of(sketch);
  std::vector<Vec3> x = sketch.positions;
  x[0].x -= 0.3;
  const auto error_of = [&](std::size_t k) { return std::abs(distance(x[k], x[k + 1]) - 1.0); };
  Resolver one(framework, {"bfs_reverse", 0.5}, {.max_sweeps = 1});
  std::vector<Vec3> start = x;
  one.resolve(x);
  EXPECT_LT(error_of(2), 1e-15);
  EXPECT_GT(error_of(0), 1e-3);
  x = start;
  Resolver two(framework, {"bfs_reverse", 0.5}, {.max_sweeps = 2});
  two.resolve(x);
  EXPECT_LT(error_of(0), 1e-15);
  EXPECT_GT(error_of(2), 1e-3);
}

TEST(Resolve, AMovedResolverResolves) {
  const Sketch sketch = ring(5);
  const Framework framework = framework_of(sketch);
  Resolver first(framework, {});
  Resolver second = std::move(first);
  std::vector<Vec3> x = test::shake(framework, sketch.positions, 0.1);
  EXPECT_TRUE(second.resolve(x).converged());
}

TEST(WalkerResolver, UsesTheBestInstructionsUnlessToldOtherwise) {
  const Framework framework = framework_of(chain(5));
  EXPECT_EQ(WalkerResolver(framework, {"blocks"}).level(), lane_level_names().front());
  EXPECT_EQ(WalkerResolver(framework, {"blocks"}, {}, {true, "portable"}).level(), "portable");
  EXPECT_EQ(WalkerResolver(framework, {"blocks"}, {}, {false, {}}).level(), "");
  EXPECT_EQ(WalkerResolver(framework, {"auto"}).level(), lane_level_names().front());
}

TEST(WalkerResolver, HasLanesForWhatIsTheSameForAllWalkers) {
  const Framework framework = framework_of(grid(3, 3));
  for (const char* name : {"bfs_cycle", "bfs_reverse", "dfs_cycle", "dfs_reverse", "input",
                           "blocks", "newton", "shake"})
    EXPECT_NE(WalkerResolver(framework, {name}).level(), "") << name;
  for (const char* name : {"random", "bfs_random", "bfs_adapt", "anderson", "units"})
    EXPECT_EQ(WalkerResolver(framework, {name}).level(), "") << name;
}

TEST(WalkerResolver, NamesTheLevelsThatItKnows) {
  const Framework framework = framework_of(chain(5));
  const std::string text = test::error_text<OptionError>([&] {
    WalkerResolver(framework, {"blocks"}, {}, {true, "v9"});
  });
  EXPECT_EQ(text.rfind("lane level = v9: must be one of ", 0), 0u) << text;
  EXPECT_NE(text.find("portable"), std::string::npos) << text;
}

TEST(WalkerResolver, TellsOfPositionsAndSummariesThatDoNotFit) {
  const Sketch sketch = chain(5);
  const Framework framework = framework_of(sketch);
  WalkerResolver resolver(framework, {"blocks"});
  std::vector<Vec3> right = sketch.positions, wrong(4);
  std::vector<ResolveSummary> summaries(2);
  const std::vector<WalkerPositions> walkers = {{0, right}, {1, wrong}};
  EXPECT_ERROR(OptionError, "positions: 4 for 5 joints", resolver.resolve(walkers, summaries));
  EXPECT_ERROR(OptionError, "summaries: 2 for 1 walkers",
               resolver.resolve(std::span(walkers).first(1), summaries));
}

TEST(WalkerResolver, TakesNoInfiniteLengthForWholeHoweverMuchIsAllowed) {
  const Framework framework({.joint_count = 2, .bars = {{0, 1}}, .rest_lengths = {10.0}});
  const ResolveOptions options{.tolerance = {.relative = 1e308}};
  for (const Measured measured :
       {Measured::nothing, Measured::max_residual, Measured::rms_residual}) {
    std::vector<Vec3> far = {{}, {1e160, 0.0, 0.0}}, near = {{}, {1.0, 0.0, 0.0}};
    const std::vector<WalkerPositions> walkers = {{0, far}, {1, near}};
    std::vector<ResolveSummary> summaries(2);
    WalkerResolver(framework, {"bfs_cycle"}, options).resolve(walkers, summaries, 0, 0, measured);
    EXPECT_EQ(summaries[0].stop, Stop::not_finite);
    EXPECT_EQ(summaries[1].stop, Stop::converged);
  }
}

TEST(WalkerResolver, MixesWalkersWithAndWithoutReference) {
  const Sketch sketch = chain(9);
  const Framework framework = framework_of(sketch);
  std::vector<std::vector<Vec3>> together, alone;
  std::vector<WalkerPositions> walkers;
  for (std::uint64_t k = 0; k < 4; ++k)
    together.push_back(test::shake(framework, sketch.positions, 0.1, k));
  alone = together;
  for (std::uint64_t k = 0; k < 4; ++k) {
    std::span<const Vec3> reference;
    if (k % 2 == 0) reference = sketch.positions;
    walkers.push_back({k, together[k], reference});
    Resolver(framework, {"shake"}).resolve(alone[k], 0, 0, reference);
  }
  std::vector<ResolveSummary> summaries(4);
  WalkerResolver(framework, {"shake"}).resolve(walkers, summaries);
  for (std::size_t k = 0; k < 4; ++k) EXPECT_TRUE(test::same_bits(together[k], alone[k]));
}

}  // namespace pliant::resolve_test
