// SPDX-License-Identifier: MIT
// Large frameworks on a small stack: nothing recurses over joints, and nothing is quadratic in the
// joints of a chain, a ring, a star or a wheel, or in the bars of a complete graph.
#include <pthread.h>

#include <ctime>

#include "pliant/framework/graph.hpp"
#include "pliant/framework/measures/residual.hpp"
#include "pliant/lab/examples/examples.hpp"
#include "pliant/order/check_ordering.hpp"
#include "pliant/resolve/resolve.hpp"
#include "pliant/resolve/techniques.hpp"
#include "support/frameworks.hpp"
#include "support/test.hpp"

namespace pliant::size_law_test {

/// Runs `work` in a thread with a stack of 256 KiB; a recursion a joint deep would not survive it.
void on_a_small_stack(std::function<void()> work) {
  pthread_attr_t attributes;
  ASSERT_EQ(pthread_attr_init(&attributes), 0);
  ASSERT_EQ(pthread_attr_setstacksize(&attributes, 256 * 1024), 0);
  pthread_t thread;
  const auto call = [](void* work_of_thread) -> void* {
    (*static_cast<std::function<void()>*>(work_of_thread))();
    return nullptr;
  };
  ASSERT_EQ(pthread_create(&thread, &attributes, call, &work), 0);
  pthread_join(thread, nullptr);
  pthread_attr_destroy(&attributes);
}

struct Large {
  const char* name;
  Sketch (*sketch)();
  std::size_t cycles, bridges, blocks;
  bool forest_rows_only = false;  ///< to save time
};

/// A hub, a rim of n joints and a spoke to each.
Sketch wheel(std::size_t spokes) {
  Sketch sketch = ring(spokes);
  sketch.positions.push_back({0, 0, 1});
  for (std::size_t i = 0; i < spokes; ++i)
    sketch.bars.push_back({static_cast<Joint>(spokes), static_cast<Joint>(i)});
  return sketch;
}

class SizeLaw : public testing::TestWithParam<Large> {};

TEST_P(SizeLaw, GraphFactsOnASmallStack) {
  on_a_small_stack([] {
    const GraphFacts facts = graph_facts(framework_of(GetParam().sketch()));
    EXPECT_EQ(facts.components, 1u);
    EXPECT_EQ(facts.cycles, GetParam().cycles);
    EXPECT_EQ(facts.bridges, GetParam().bridges);
    EXPECT_EQ(facts.blocks, GetParam().blocks);
  });
}

TEST_P(SizeLaw, OrderingsOnASmallStack) {
  on_a_small_stack([] {
    const Sketch sketch = GetParam().sketch();
    const Framework framework = framework_of(sketch);
    const auto middle = static_cast<Joint>(framework.joint_count() / 2);
    for (const OrderingEntry& entry : orderings()) {
      if (GetParam().forest_rows_only && !entry.forests_only) continue;
      OrderScratch scratch;
      Ordering out;
      entry.order({.framework = framework, .root = middle, .positions = sketch.positions}, scratch,
                  out);
      const OrderingPromise promise{.all_bars = !entry.forests_only, .tree_bars = false};
      EXPECT_EQ(check_ordering(framework, out, promise), "") << entry.name;
    }
  });
}

TEST_P(SizeLaw, TechniquesOnASmallStack) {
  on_a_small_stack([] {
    const Sketch sketch = GetParam().sketch();
    const Framework framework = framework_of(sketch);
    std::vector<Vec3> broken = sketch.positions;
    broken[0] += Vec3{0.1, 0.1, 0.1};
    for (const TechniqueEntry& entry : techniques()) {
      if (entry.forests_only && GetParam().cycles > 0) continue;
      if (GetParam().forest_rows_only && !entry.forests_only && entry.has_weighting) continue;
      const ResolveOptions options{.max_sweeps = 2};
      std::vector<Vec3> x = broken;
      const std::clock_t start = std::clock();
      const ResolveSummary summary = resolve(framework, {std::string(entry.name), 0.5}, x, options);
      const double seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
      EXPECT_LE(summary.sweeps, options.max_sweeps) << entry.name;
      EXPECT_TRUE(test::all_finite(x)) << entry.name;
      // Of the processor. Generous: a sanitized Debug build; quadratic work takes minutes.
      EXPECT_LT(seconds, 20.0) << entry.name;
    }
  });
}

/// Joints of the chain and of the ring; with PLIANT_ALL five times as many.
std::size_t large(std::size_t joints) {
  return std::getenv("PLIANT_ALL") == nullptr ? joints : 5 * joints;
}

INSTANTIATE_TEST_SUITE_P(
    Families, SizeLaw,
    testing::Values(Large{"chain", [] { return chain(large(200000)); }, 0, large(200000) - 1, 0,
                          true},
                    Large{"ring", [] { return ring(large(20000)); }, 1, 0, 1},
                    Large{"star_1e5", [] { return star(100000); }, 0, 100000, 0},
                    Large{"wheel_2e4", [] { return wheel(20000); }, 20000, 0, 1},
                    Large{"complete_200", [] { return complete(200); }, 19900 - 199, 0, 1}),
    [](const auto& row) { return std::string(row.param.name); });

}  // namespace pliant::size_law_test
