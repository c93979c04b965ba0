// SPDX-License-Identifier: MIT
#include "pliant/resolve/walkers.hpp"

#include <gtest/gtest.h>

#include "pliant/lab/examples/examples.hpp"
#include "support/error_text.hpp"
#include "support/frameworks.hpp"

namespace pliant {
namespace walkers_test {

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
  EXPECT_EQ(test::error_text<OptionError>([&] { resolver.resolve(walkers, summaries); }),
            "positions: 4 for 5 joints");
  EXPECT_EQ(test::error_text<OptionError>(
                [&] { resolver.resolve(std::span(walkers).first(1), summaries); }),
            "summaries: 2 for 1 walkers");
}

TEST(WalkerResolver, TakesNoInfiniteLengthForWholeHoweverMuchIsAllowed) {
  const Framework framework({.joint_count = 2, .bars = {{0, 1}}, .rest_lengths = {10.0}});
  ResolveOptions options;
  options.tolerance.relative = 1e308;
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

}  // namespace walkers_test
}  // namespace pliant
