// SPDX-License-Identifier: MIT
// What is known of frameworks at and beyond the edge of what can be: where an infeasible framework
// comes to rest, and what a singular one still reaches; and laws on frameworks that nobody thought
// of.
#include <rapidcheck/gtest.h>

#include "pliant/framework/graph.hpp"
#include "pliant/framework/measures/residual.hpp"
#include "pliant/lab/examples/examples.hpp"
#include "pliant/order/check_ordering.hpp"
#include "pliant/resolve/resolve.hpp"
#include "pliant/resolve/techniques.hpp"
#include "support/frameworks.hpp"
#include "support/random_frameworks.hpp"
#include "support/test.hpp"

namespace pliant::impossible_law_test {

/// Signed length errors after very many sweeps.
std::vector<double> errors_at_rest(const Example& example, std::int64_t sweeps = 20000) {
  std::vector<Vec3> x = example.positions;
  const ResolveSummary summary =
      resolve(example.framework, {"input", 0.5}, x, {.max_sweeps = sweeps});
  EXPECT_EQ(summary.stop, Stop::max_sweeps);
  std::vector<double> errors;
  for (std::size_t k = 0; k < example.framework.bar_count(); ++k) {
    const Bar bar = example.framework.bars()[k];
    errors.push_back(residual(x[bar.a], x[bar.b], example.framework.rest_lengths()[k]));
  }
  return errors;
}

/// A polygon that cannot close comes to rest on a line, its errors adding up to what is lacking. A
/// sweep leaves its last bar whole and the others to share; least squares would give D / n each.
TEST(Impossible, OpenPolygonsLackWhatTheyLack) {
  const std::pair<const char*, double> lacking[] = {{"triangle_1_1_3", 1.0},
                                                    {"polygon_open_1_1_1_4", 1.0},
                                                    {"polygon_open_1_2_3_7", 1.0},
                                                    {"polygon_open_1_1_1_1_6", 2.0}};
  for (const auto& [name, deficit] : lacking) {
    SCOPED_TRACE(name);
    double sum = 0.0;
    for (double error : errors_at_rest(find_example(name))) sum += std::abs(error);
    EXPECT_NEAR(sum, deficit, 1e-6);
  }
}

/// Ends pinned 12 apart, ten unit bars: 2 are lacking.
TEST(Impossible, AStretchedChainIsStretched) {
  double sum = 0.0;
  for (double error : errors_at_rest(find_example("pinned_ends_too_far_12"))) {
    EXPECT_GT(error, -1e-9);
    sum += error;
  }
  EXPECT_NEAR(sum, 2.0, 1e-9);
}

TEST(Impossible, TwoPinnedJointsAtAWrongDistanceAreToldAtOnce) {
  const Example& example = find_example("pinned_pair_wrong_distance");
  for (const TechniqueEntry& entry : techniques()) {
    SCOPED_TRACE(entry.name);
    std::vector<Vec3> x = example.positions;
    const ResolveSummary summary = resolve(example.framework, {std::string(entry.name)}, x);
    EXPECT_EQ(summary.stop, Stop::max_sweeps);
    EXPECT_EQ(summary.max_residual, 1.0);
    EXPECT_EQ(x, example.positions);
  }
}

/// Taut: error e in a bar costs sqrt(e) sideways, so sweeps slow down without end; they come near.
TEST(Impossible, TautFrameworksComeNear) {
  for (const char* name :
       {"triangle_1_2_3_taut", "polygon_taut_1_1_1_3", "polygon_taut_1_2_3_6",
        "polygon_taut_1_1_1_1_4", "pinned_ends_taut_10", "K4_five_unit_bars_one_sqrt3"}) {
    const Example& example = find_example(name);
    SCOPED_TRACE(name);
    std::vector<Vec3> x = example.positions;
    EXPECT_TRUE(
        resolve(example.framework, {"bfs_reverse", 0.5}, x, {.tolerance = {.relative = 1e-3}})
            .converged());
  }
}

/// With bars of at most 1.0005 between ends 10 apart each joint lies in an ellipse about the ends
/// whose half axes are 5.0025 and sqrt(5.0025^2 - 5^2) = 0.158.
TEST(Impossible, TheTautChainIsStraight) {
  const Example& example = find_example("pinned_ends_taut_10");
  std::vector<Vec3> x = example.positions;
  ASSERT_TRUE(
      resolve(example.framework, {"input", 0.5}, x, {.tolerance = {.relative = 5e-4}}).converged());
  for (std::size_t k = 0; k <= 10; ++k) EXPECT_LT(distance(x[k], {double(k), 0, 0}), 0.16);
}

/// Bars of 1e-6 to 1e6 Angstrom in one chain: the tolerance is relative to each.
TEST(Impossible, ThirteenDecadesOfLengthInOneChain) {
  Sketch sketch;
  sketch.positions.push_back({});
  for (int power = -6; power <= 6; ++power) {
    const double length = std::pow(10.0, power);
    sketch.positions.push_back(sketch.positions.back() +
                               (power % 2 == 0 ? Vec3{length, 0, 0} : Vec3{0, length, 0}));
    const auto last = static_cast<Joint>(sketch.positions.size() - 1);
    sketch.bars.push_back({last - 1, last});
  }
  const Framework framework = framework_of(sketch);
  std::vector<Vec3> x = sketch.positions;
  for (std::size_t i = 1; i < x.size(); ++i) x[i] += 0.1 * (x[i] - sketch.positions[i - 1]);
  const ResolveSummary summary = resolve(framework, {"bfs_tree", 1.0}, x);
  EXPECT_TRUE(summary.converged()) << summary.brief(framework);
  EXPECT_EQ(summary.sweeps, 1);
}

Technique any_technique(const Framework& framework) {
  const bool is_forest = graph_facts(framework).is_forest();
  std::vector<Technique> fitting;
  for (const TechniqueEntry& entry : techniques())
    if (is_forest || !entry.forests_only) fitting.push_back({std::string(entry.name)});
  Technique technique = *rc::gen::elementOf(fitting);
  technique.weighting = 0.125 * *rc::gen::inRange(0, 9);
  technique.mass_weighted = *rc::gen::arbitrary<bool>();
  return technique;
}

RC_GTEST_PROP(AnyFrameworkLaw, TheSummaryIsTrueAndTheSameTwice, ()) {
  const test::AnyFramework any = test::any_framework(10, 30);
  const Technique technique = any_technique(any.framework);
  RC_LOG() << technique.name << " " << technique.weighting << "\n";
  const ResolveOptions options{.tolerance = {.relative = 1e-4},
                               .max_sweeps = *rc::gen::inRange(1, 100)};
  const auto root = static_cast<Joint>(*rc::gen::inRange(0, int(any.positions.size())));
  std::vector<Vec3> x = any.positions, y = any.positions;
  const ResolveSummary summary = resolve(any.framework, technique, x, options, root);
  const ResidualSummary found = measure(any.framework, x, options.tolerance);
  RC_ASSERT(test::all_finite(x));
  RC_ASSERT(summary.converged() == found.within);
  RC_ASSERT(summary.converged() || summary.sweeps == options.max_sweeps);
  RC_ASSERT(summary.max_residual == found.max_relative);
  for (std::size_t i = 0; i < x.size(); ++i)
    RC_ASSERT(!any.framework.is_pinned(static_cast<Joint>(i)) || x[i] == any.positions[i]);
  const ResolveSummary again = resolve(any.framework, technique, y, options, root);
  RC_ASSERT(test::same_bits(x, y));
  RC_ASSERT(summary.sweeps == again.sweeps);
}

RC_GTEST_PROP(AnyFrameworkLaw, OrderingsVisitEachBarOnce, ()) {
  const test::AnyFramework any = test::any_framework(14, 40);
  const auto root = static_cast<Joint>(*rc::gen::inRange(0, int(any.positions.size())));
  for (const OrderingEntry& entry : orderings()) {
    OrderScratch scratch;
    Ordering before, now;
    for (std::int64_t sweep = 0; sweep < 3; ++sweep) {
      entry.order({any.framework, root, sweep, {}, any.positions, sweep > 0 ? &before : nullptr},
                  scratch, now);
      const OrderingPromise promise{.all_bars = !entry.forests_only,
                                    .tree_bars = entry.forests_only};
      RC_ASSERT(check_ordering(any.framework, now, promise) == "");
      before.swap(now);
    }
  }
}

/// A framework at rest, pushed a little, comes back near where it was: the bars keep their side.
RC_GTEST_PROP(AnyFrameworkLaw, SmallBreaksOfForestsAreMendedNearby, ()) {
  test::AnyFramework any = test::any_framework(12, 6);
  RC_PRE(graph_facts(any.framework).is_forest() && !any.framework.has_pinned_joints());
  std::vector<Vec3> x = any.positions;
  const ResolveOptions options{.tolerance = {.relative = 1e-12}};
  const Technique tree{"dfs_tree", 1.0};
  RC_ASSERT(resolve(any.framework, tree, x, options).converged());
  const std::vector<Vec3> whole = x;
  x = test::shake(any.framework, x, 0.01);
  const ResolveSummary summary = resolve(any.framework, tree, x, options);
  RC_ASSERT(summary.converged());
  RC_ASSERT(summary.sweeps <= 1);
  RC_ASSERT(test::largest_difference(x, whole) < 0.01 * 2.0 * 12.0);
}

}  // namespace pliant::impossible_law_test
