// SPDX-License-Identifier: MIT
// The laws on frameworks that nobody thought of.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "pliant/framework/graph.hpp"
#include "pliant/framework/measures/residual.hpp"
#include "pliant/order/check_ordering.hpp"
#include "pliant/resolve/resolve.hpp"
#include "pliant/resolve/techniques.hpp"
#include "support/frameworks.hpp"
#include "support/random_frameworks.hpp"

namespace pliant {
namespace random_law_test {

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
  ResolveOptions options;
  options.max_sweeps = *rc::gen::inRange(1, 100);
  options.tolerance.relative = 1e-4;
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
  ResolveOptions options;
  options.tolerance.relative = 1e-12;
  const Technique tree{"dfs_tree", 1.0};
  RC_ASSERT(resolve(any.framework, tree, x, options).converged());
  const std::vector<Vec3> whole = x;
  x = test::shake(any.framework, x, 0.01);
  const ResolveSummary summary = resolve(any.framework, tree, x, options);
  RC_ASSERT(summary.converged());
  RC_ASSERT(summary.sweeps <= 1);
  RC_ASSERT(test::largest_difference(x, whole) < 0.01 * 2.0 * 12.0);
}

}  // namespace random_law_test
}  // namespace pliant
