// SPDX-License-Identifier: MIT
#include "pliant/resolve/sweeps/anderson.hpp"

#include "pliant/base/random.hpp"
#include "pliant/lab/examples/examples.hpp"
#include "pliant/lab/generate/random_graphs.hpp"
#include "pliant/resolve/sweeps/anderson_sweeps.hpp"
#include "support/frameworks.hpp"
#include "support/test.hpp"

namespace pliant::anderson_test {

/// g(x) = rate x, coordinate by coordinate, about 0.
std::vector<Vec3> linear_step(const std::vector<Vec3>& x, const std::vector<Vec3>& rates) {
  std::vector<Vec3> g;
  for (std::size_t i = 0; i < x.size(); ++i)
    g.push_back({rates[i].x * x[i].x, rates[i].y * x[i].y, rates[i].z * x[i].z});
  return g;
}

double length(const std::vector<Vec3>& x) {
  double squared = 0.0;
  for (Vec3 p : x) squared += norm_squared(p);
  return std::sqrt(squared);
}

/// How far from 0 a linear sequence is after each of `steps` mixed steps, from (1, 1, 1)s.
std::vector<double> distances(const std::vector<Vec3>& rates, int steps) {
  AndersonMixing mixing;
  std::vector<Vec3> x(rates.size(), Vec3{1, 1, 1});
  std::vector<double> out;
  for (int k = 0; k < steps; ++k) {
    const std::vector<Vec3> g = linear_step(x, rates);
    std::vector<Vec3> f(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) f[i] = g[i] - x[i];
    x = mixing.mix(f, g) ? f : g;
    out.push_back(length(x));
  }
  return out;
}

TEST(AndersonMixing, HasNothingToGoByAtFirst) {
  AndersonMixing mixing;
  std::vector<Vec3> f{{1, 2, 3}};
  const std::vector<Vec3> before = f, g{{4, 5, 6}};
  EXPECT_FALSE(mixing.mix(f, g));
  EXPECT_EQ(f, before);
  f = {{0.5, 1.0, 1.5}};
  EXPECT_TRUE(mixing.mix(f, g));
  mixing.restart();
  f = before;
  EXPECT_FALSE(mixing.mix(f, g));
}

/// One rate: the limit of a geometric series, found from two terms (Aitken, 1926).
TEST(AndersonMixing, FindsTheLimitOfAGeometricSequenceAtOnce) {
  for (double rate : {0.5, 0.9, 0.99, -0.7, 1.5})
    EXPECT_LT(distances({{rate, rate, rate}}, 2)[1], 3e-4) << rate;
}

/// k different rates are gone after k + 1 steps, as with GMRES, but for what the ridge leaves;
/// plain steps leave 0.9^4 = 0.66 of it.
TEST(AndersonMixing, EndsALinearSequenceInAsManyStepsAsItHasRates) {
  EXPECT_LT(distances({{0.9, 0.3, 0.9}}, 3)[2], 1e-3);
  const auto three = distances({{0.9, 0.5, 0.2}}, 4);
  EXPECT_GT(three[1], 1e-2);
  EXPECT_LT(three[3], 2e-3);
}

/// Sixty rates up to 0.99: far ahead of plain steps, which leave 0.99^40 = 0.67 of the slowest.
TEST(AndersonMixing, HastensWhatItCannotEnd) {
  std::vector<Vec3> rates;
  for (int i = 0; i < 20; ++i) rates.push_back({0.04 * i, 0.04 * i + 0.1, 0.99 - 0.03 * i});
  EXPECT_LT(distances(rates, 40)[39], 0.05);
}

/// The weights add up to 1: what all g share is kept, to rounding.
TEST(AndersonMixing, KeepsWhatEveryStepKeeps) {
  AndersonMixing mixing;
  RandomSequence draws({3, Domain::generate});
  for (int k = 0; k < 8; ++k) {
    std::vector<Vec3> f, g;
    for (int i = 0; i < 4; ++i) {
      f.push_back(draws.direction());
      g.push_back(draws.direction());
    }
    f.push_back({});          // pinned
    g.push_back({7, -8, 9});  // pinned
    const Vec3 sum = g[0] + g[1] + g[2];
    g[3] = Vec3{5, 0, 1} - sum;
    if (!mixing.mix(f, g)) continue;
    EXPECT_EQ(f[4], (Vec3{7, -8, 9}));
    EXPECT_LT(distance(f[0] + f[1] + f[2] + f[3], Vec3{5, 0, 1}), 1e-12);
  }
}

TEST(AndersonMixing, DoesNotFollowWhatIsNotFinite) {
  AndersonMixing mixing;
  std::vector<Vec3> f{{1, 0, 0}};
  EXPECT_FALSE(mixing.mix(f, std::vector<Vec3>{{1, 1, 1}}));
  f = {{HUGE_VAL, 0, 0}};
  EXPECT_FALSE(mixing.mix(f, std::vector<Vec3>{{1, 1, 1}}));
  EXPECT_EQ(f[0].x, HUGE_VAL);
}

/// Twice the same step: the columns are 0, and there is nothing to solve.
TEST(AndersonMixing, GivesUpWhereNothingChanges) {
  AndersonMixing mixing;
  std::vector<Vec3> f{{1, 0, 0}};
  const std::vector<Vec3> g{{1, 1, 1}};
  EXPECT_FALSE(mixing.mix(f, g));
  EXPECT_FALSE(mixing.mix(f, g));
}

/// Graphs of every class with cycles, each pushed hard.
template <class Look>
void each_pushed_graph(Look look) {
  for (const GraphClass& kind : graph_classes()) {
    if (kind.family == "tree") continue;
    for (std::uint64_t number = 0; number < 20; ++number) {
      const GeneratedGraph graph =
          generate(kind, {.cycles = 4, .joints = 30},
                   {.seed = 5, .domain = Domain::generate, .walker = number});
      std::vector<Vec3> x = graph.positions;
      const auto root = static_cast<Joint>(number % x.size());
      x[root] += 3.0 * RandomSequence({number, Domain::force}).direction();
      SCOPED_TRACE(std::string(kind.name) + " " + std::to_string(number));
      look(graph.framework, x, root);
    }
  }
}

ResolveSummary resolved_within(const Technique& technique, const Framework& framework,
                               std::vector<Vec3> x, Joint root) {
  return resolve(framework, technique, x, {.max_sweeps = 100000}, root);
}

/// The promise of AcceleratedSweeps: what P plain sweeps resolve takes at most 3 P + 50.
TEST(Anderson, IsNeverWorseThanPlainByMoreThanItsPromise) {
  each_pushed_graph([](const Framework& framework, const std::vector<Vec3>& x, Joint root) {
    for (double weighting : {0.5, 1.0}) {
      const auto plain = resolved_within({"bfs_cycle", weighting}, framework, x, root);
      const auto fast = resolved_within({"anderson", weighting}, framework, x, root);
      EXPECT_GE(fast.converged(), plain.converged());
      EXPECT_LE(fast.sweeps, 3 * plain.sweeps + 50) << weighting;
    }
  });
}

/// What it is for: it resolves all but a few of 140 pushed graphs with less work than plain sweeps,
/// and on the whole with less than half of it.
TEST(Anderson, NeedsLessWorkThanPlainSweeps) {
  std::int64_t plain_work = 0, fast_work = 0;
  int graphs = 0, less = 0;
  each_pushed_graph([&](const Framework& framework, const std::vector<Vec3>& x, Joint root) {
    const auto plain = resolved_within({"bfs_cycle", 0.5}, framework, x, root);
    const auto fast = resolved_within({"anderson", 0.5}, framework, x, root);
    plain_work += plain.projections;
    fast_work += fast.projections;
    ++graphs;
    less += fast.projections < plain.projections;
  });
  EXPECT_EQ(graphs, 140);
  EXPECT_GE(less, 137);
  EXPECT_LT(2 * fast_work, plain_work);
}

}  // namespace pliant::anderson_test
