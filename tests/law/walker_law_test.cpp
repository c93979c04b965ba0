// SPDX-License-Identifier: MIT
// A walker ends with the same bits in lanes as alone, whatever the level of instructions, its place
// among the lanes and its neighbours, and its summary is the same.
#include "pliant/resolve/walkers.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "law/technique_cases.hpp"

namespace pliant {
namespace walker_law_test {

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

ResolveOptions few_sweeps() {
  ResolveOptions options;
  options.max_sweeps = 60;
  options.seed = 7;
  return options;
}

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

}  // namespace walker_law_test
}  // namespace pliant
