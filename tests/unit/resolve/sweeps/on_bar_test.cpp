// SPDX-License-Identifier: MIT
// Watching bars being repaired one by one: ResolveOptions::on_bar.
#include <gtest/gtest.h>

#include "pliant/lab/examples/examples.hpp"
#include "pliant/order/ordering.hpp"
#include "pliant/resolve/techniques.hpp"
#include "pliant/resolve/walkers.hpp"
#include "support/error_text.hpp"
#include "support/frameworks.hpp"

namespace pliant {
namespace on_bar_test {

std::vector<Vec3> pushed(const Sketch& sketch) {
  std::vector<Vec3> x = sketch.positions;
  x[1] += Vec3{0.1, 0.2, 0.3};
  return x;
}

/// Each visit is shown with the positions that it left, and watching changes nothing.
TEST(OnBar, ShowsEachVisitOfEveryOrdering) {
  const Sketch sketch = chain(7);
  const Framework framework = framework_of(sketch);
  for (const OrderingEntry& row : orderings()) {
    SCOPED_TRACE(row.name);
    std::vector<Vec3> watched = pushed(sketch), alone = watched, last;
    std::int64_t visits = 0;
    ResolveOptions options;
    options.on_bar = [&](const RepairedBar& repaired) {
      const Bar bar = framework.bars()[repaired.bar];
      EXPECT_EQ(std::minmax(bar.a, bar.b), std::minmax(repaired.near, repaired.far));
      for (Joint joint = 0; joint < last.size(); ++joint) {
        EXPECT_TRUE(joint == repaired.near || joint == repaired.far ||
                    last[joint] == repaired.positions[joint]);
      }
      last.assign(repaired.positions.begin(), repaired.positions.end());
      ++visits;
    };
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
  ResolveOptions options;
  options.on_bar = [](const RepairedBar&) {};
  for (const TechniqueEntry& row : techniques()) {
    const bool is_ordering =
        std::any_of(orderings().begin(), orderings().end(),
                    [&](const OrderingEntry& ordering) { return ordering.name == row.name; });
    const Technique technique{std::string(row.name)};
    if (is_ordering) {
      EXPECT_NO_THROW(Resolver(framework, technique, options)) << row.name;
    } else {
      EXPECT_THROW(Resolver(framework, technique, options), OptionError) << row.name;
    }
  }
  EXPECT_EQ(test::error_text<OptionError>([&] { Resolver(framework, {"blocks"}, options); }),
            "on_bar: technique blocks does not go bar by bar; orderings do");
}

TEST(OnBar, WalkersAreWatchedToo) {
  const Sketch sketch = chain(7);
  const Framework framework = framework_of(sketch);
  std::vector<std::vector<Vec3>> conformers(9, pushed(sketch));
  std::vector<WalkerPositions> walkers;
  for (std::uint64_t k = 0; k < 9; ++k) walkers.push_back({k, conformers[k]});
  std::vector<ResolveSummary> summaries(9);
  std::int64_t visits = 0, projections = 0;
  ResolveOptions options;
  options.on_bar = [&](const RepairedBar&) { ++visits; };
  WalkerResolver resolver(framework, {"bfs_cycle"}, options);
  EXPECT_EQ(resolver.level(), "");
  resolver.resolve(walkers, summaries, 1);
  for (const ResolveSummary& summary : summaries) projections += summary.projections;
  EXPECT_EQ(visits, projections);
}

}  // namespace on_bar_test
}  // namespace pliant
