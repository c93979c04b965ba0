// SPDX-License-Identifier: MIT
// A walker ends with the same bits in lanes as alone, whatever the level of instructions, its place
// among the lanes and its neighbours, and its summary is the same.
#include "pliant/resolve/walkers.hpp"

#include <rapidcheck/gtest.h>

#include "law/technique_cases.hpp"
#include "support/random_frameworks.hpp"
#include "support/test.hpp"

namespace pliant::walker_law_test {

constexpr Joint root = 0;
constexpr std::int64_t step = 3;

using Conformers = std::vector<std::vector<Vec3>>;

/// Small breaks and large ones, one walker that is whole, one with joints in one place, and one
/// that is nowhere.
Conformers broken_conformers(const Example& example) {
  const Framework& framework = example.framework;
  Conformers all;
  for (std::uint64_t seed = 0; seed < 10; ++seed)
    all.push_back(test::shake(framework, example.positions,
                              test::small_break(framework) * (seed < 7 ? 1.0 : 6.0), seed));
  all[2] = example.positions;
  if (framework.bar_count() > 0) {
    const Bar bar = framework.bars().back();
    all[4][bar.a] = all[4][bar.b];
    if (!framework.is_pinned(bar.a)) all[9][bar.a].x = 1e308;
  }
  all.push_back(all[0]);  // a second group, of which one walker is a group of its own
  return all;
}

ResolveOptions few_sweeps() { return {.max_sweeps = 60, .seed = 7}; }

struct Resolved {
  Conformers positions;
  std::vector<ResolveSummary> summaries;
};

Resolved resolve_alone(const Example& example, const Technique& technique, Conformers positions) {
  Resolved alone{std::move(positions), {}};
  for (std::size_t k = 0; k < alone.positions.size(); ++k) {
    ResolveOptions options = few_sweeps();
    options.walker = k;
    Resolver resolver(example.framework, technique, options);
    alone.summaries.push_back(resolver.resolve(alone.positions[k], root, step, example.positions));
  }
  return alone;
}

Resolved resolve_together(const Example& example, const Technique& technique, Conformers positions,
                          const LaneOptions& lanes, Measured measured = Measured::rms_residual) {
  Resolved together{std::move(positions), {}};
  std::vector<WalkerPositions> walkers;
  for (std::size_t k = 0; k < together.positions.size(); ++k)
    walkers.push_back({k, together.positions[k], example.positions});
  together.summaries.resize(walkers.size());
  WalkerResolver resolver(example.framework, technique, few_sweeps(), lanes);
  resolver.resolve(walkers, together.summaries, root, step, measured);
  return together;
}

void expect_same(const Resolved& expected, const Resolved& found) {
  for (std::size_t k = 0; k < expected.positions.size(); ++k) {
    SCOPED_TRACE("walker " + std::to_string(k));
    EXPECT_TRUE(test::same_bits(found.positions[k], expected.positions[k]));
    const ResolveSummary &a = found.summaries[k], &b = expected.summaries[k];
    EXPECT_EQ(a.stop, b.stop);
    EXPECT_EQ(a.sweeps, b.sweeps);
    EXPECT_EQ(a.projections, b.projections);
    EXPECT_EQ(a.dropped_bars, b.dropped_bars);
    EXPECT_EQ(a.finishing_sweeps, b.finishing_sweeps);
    EXPECT_EQ(a.max_residual, b.max_residual);
    EXPECT_EQ(a.rms_residual, b.rms_residual);
    EXPECT_EQ(a.off_nearest, b.off_nearest);
    EXPECT_EQ(a.worst_bar, b.worst_bar);
  }
}

class WalkerLaw : public test::TechniqueLaw {};
PLIANT_FOR_ALL_TECHNIQUES(WalkerLaw);

TEST_P(WalkerLaw, EndsInLanesAsAlone) {
  each_case([](const Example& example, const Technique& technique) {
    const Conformers broken = broken_conformers(example);
    const Resolved alone = resolve_alone(example, technique, broken);
    for (const std::string_view level : lane_level_names()) {
      SCOPED_TRACE(level);
      expect_same(alone, resolve_together(example, technique, broken, {true, level}));
    }
    expect_same(alone, resolve_together(example, technique, broken, {false, {}}));
  });
}

TEST_P(WalkerLaw, EndsTheSameWhateverIsMeasured) {
  each_example([](const Example& example) {
    const Conformers broken = broken_conformers(example);
    const Resolved all = resolve_together(example, plain(), broken, {});
    for (const Measured measured : {Measured::nothing, Measured::max_residual}) {
      const Resolved less = resolve_together(example, plain(), broken, {}, measured);
      for (std::size_t k = 0; k < broken.size(); ++k) {
        SCOPED_TRACE("walker " + std::to_string(k));
        const bool none = measured == Measured::nothing;
        EXPECT_TRUE(test::same_bits(less.positions[k], all.positions[k]));
        EXPECT_EQ(less.summaries[k].stop, all.summaries[k].stop);
        EXPECT_EQ(less.summaries[k].sweeps, all.summaries[k].sweeps);
        EXPECT_EQ(less.summaries[k].rms_residual, -1.0);
        EXPECT_EQ(less.summaries[k].max_residual, none ? -1.0 : all.summaries[k].max_residual);
      }
    }
  });
}

TEST_P(WalkerLaw, DoesNotDependOnItsPlaceOrItsNeighbours) {
  each_example([](const Example& example) {
    const Technique technique = plain();
    Conformers broken = broken_conformers(example);
    const Resolved forward = resolve_together(example, technique, broken, {});
    std::vector<WalkerPositions> walkers;
    for (std::size_t k = broken.size(); k-- > 0;)
      if (k % 3 != 1) walkers.push_back({k, broken[k], example.positions});
    std::vector<ResolveSummary> summaries(walkers.size());
    WalkerResolver(example.framework, technique, few_sweeps())
        .resolve(walkers, summaries, root, step);
    for (const WalkerPositions& walker : walkers)
      EXPECT_TRUE(test::same_bits(walker.positions, forward.positions[walker.walker]));
  });
}

constexpr std::int64_t random_step = 5;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// Coordinates that have led computations astray.
double any_nasty_number() {
  return *rc::gen::element(0.0, -0.0, 1e-160, -1e-160, 1e8, 1e160, 1e300, -1e308, infinity, nan);
}

/// Where the joints are on their lattice, pushed, and now and then one coordinate is nasty.
std::vector<Vec3> any_positions(const std::vector<Vec3>& lattice) {
  const double size = *rc::gen::element(0.0, 1e-9, 0.01, 0.1, 1.0, 50.0);
  std::vector<Vec3> positions = lattice;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    RandomSequence draws({.seed = *rc::gen::arbitrary<std::uint64_t>(), .joint = i});
    positions[i] += size * draws.direction();
  }
  if (*rc::gen::inRange(0, 6) == 5)
    positions[*rc::gen::inRange<std::size_t>(0, positions.size())].x = any_nasty_number();
  return positions;
}

Technique any_technique() {
  return {*rc::gen::element<std::string>("auto", "bfs_cycle", "bfs_reverse", "dfs_cycle", "input",
                                         "blocks", "newton", "shake", "units"),
          *rc::gen::element(0.0, 0.3, 0.5, 1.0), *rc::gen::arbitrary<bool>()};
}

ResolveOptions any_options() {
  return {.tolerance = {.relative = *rc::gen::element(1e-15, 1e-12, 1e-6, 1e-2, 0.3, 2.0, 1e308),
                        .length = *rc::gen::element(0.0, 0.0, 0.0, 0.1)},
          .max_sweeps = *rc::gen::element(1, 2, 3, 60),
          .seed = *rc::gen::arbitrary<std::uint64_t>()};
}

/// Bit by bit, but that every NaN is the same.
bool same(double a, double b) {
  return std::memcmp(&a, &b, sizeof a) == 0 || (std::isnan(a) && std::isnan(b));
}
bool same(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  for (std::size_t i = 0; i < a.size(); ++i)
    if (!same(a[i].x, b[i].x) || !same(a[i].y, b[i].y) || !same(a[i].z, b[i].z)) return false;
  return true;
}

void expect_same(const ResolveSummary& a, const ResolveSummary& b, Measured measured) {
  RC_ASSERT(a.stop == b.stop);
  RC_ASSERT(a.sweeps == b.sweeps);
  RC_ASSERT(a.projections == b.projections);
  RC_ASSERT(a.dropped_bars == b.dropped_bars);
  RC_ASSERT(a.finishing_sweeps == b.finishing_sweeps);
  RC_ASSERT(same(a.off_nearest, b.off_nearest));
  if (measured == Measured::nothing) return;
  RC_ASSERT(same(a.max_residual, b.max_residual));
  RC_ASSERT(a.worst_bar == b.worst_bar);
  if (measured == Measured::rms_residual) RC_ASSERT(same(a.rms_residual, b.rms_residual));
}

RC_GTEST_PROP(WalkerRandomLaw, AnyWalkerEndsInLanesAsAlone, ()) {
  const test::AnyFramework any = test::any_framework(9, 14);
  const Technique technique = any_technique();
  const ResolveOptions options = any_options();
  const Joint root = *rc::gen::inRange<Joint>(0, Joint(any.positions.size()));
  Conformers alone;
  for (int k = *rc::gen::inRange(2, 12); k > 0; --k) alone.push_back(any_positions(any.positions));
  Conformers together = alone;
  std::vector<ResolveSummary> expected, found(alone.size());
  std::vector<WalkerPositions> walkers;
  for (std::size_t k = 0; k < alone.size(); ++k) {
    ResolveOptions own = options;
    own.walker = k;
    expected.push_back(Resolver(any.framework, technique, own)
                           .resolve(alone[k], root, random_step, any.positions));
    walkers.push_back({k, together[k], any.positions});
  }
  const Measured measured =
      *rc::gen::element(Measured::nothing, Measured::max_residual, Measured::rms_residual);
  const LaneOptions lanes{true, *rc::gen::elementOf(std::vector<std::string_view>(
                                    lane_level_names().begin(), lane_level_names().end()))};
  WalkerResolver resolver(any.framework, technique, options, lanes);
  resolver.resolve(walkers, found, root, random_step, measured);
  for (std::size_t k = 0; k < alone.size(); ++k) {
    RC_ASSERT(same(together[k], alone[k]));
    expect_same(expected[k], found[k], measured);
  }
}

}  // namespace pliant::walker_law_test
