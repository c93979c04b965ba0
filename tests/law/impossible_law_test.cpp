// SPDX-License-Identifier: MIT
// What is known of frameworks at and beyond the edge of what can be: where an infeasible framework
// comes to rest, and what a singular one still reaches.
#include <gtest/gtest.h>

#include <cmath>

#include "pliant/framework/measures/residual.hpp"
#include "pliant/lab/examples/examples.hpp"
#include "pliant/resolve/resolve.hpp"
#include "pliant/resolve/techniques.hpp"

namespace pliant {
namespace impossible_law_test {

/// Signed length errors after very many sweeps.
std::vector<double> errors_at_rest(const Example& example, std::int64_t sweeps = 20000) {
  std::vector<Vec3> x = example.positions;
  ResolveOptions options;
  options.max_sweeps = sweeps;
  const ResolveSummary summary = resolve(example.framework, {"input", 0.5}, x, options);
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
    ResolveOptions options;
    options.tolerance.relative = 1e-3;
    EXPECT_TRUE(resolve(example.framework, {"bfs_reverse", 0.5}, x, options).converged());
  }
}

/// With bars of at most 1.0005 between ends 10 apart each joint lies in an ellipse about the ends
/// whose half axes are 5.0025 and sqrt(5.0025^2 - 5^2) = 0.158.
TEST(Impossible, TheTautChainIsStraight) {
  const Example& example = find_example("pinned_ends_taut_10");
  std::vector<Vec3> x = example.positions;
  ResolveOptions options;
  options.tolerance.relative = 5e-4;
  ASSERT_TRUE(resolve(example.framework, {"input", 0.5}, x, options).converged());
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

}  // namespace impossible_law_test
}  // namespace pliant
