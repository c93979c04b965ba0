// SPDX-License-Identifier: MIT
// Any framework, any positions, numbers that are none among them: a walker ends in lanes as alone.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "pliant/resolve/walkers.hpp"
#include "support/random_frameworks.hpp"

namespace pliant {
namespace walker_random_law_test {

constexpr std::int64_t step = 5;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

using Conformers = std::vector<std::vector<Vec3>>;

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
  ResolveOptions options;
  options.max_sweeps = *rc::gen::element(1, 2, 3, 60);
  options.tolerance.relative = *rc::gen::element(1e-15, 1e-12, 1e-6, 1e-2, 0.3, 2.0, 1e308);
  options.tolerance.length = *rc::gen::element(0.0, 0.0, 0.0, 0.1);
  options.seed = *rc::gen::arbitrary<std::uint64_t>();
  return options;
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
    expected.push_back(
        Resolver(any.framework, technique, own).resolve(alone[k], root, step, any.positions));
    walkers.push_back({k, together[k], any.positions});
  }
  const Measured measured =
      *rc::gen::element(Measured::nothing, Measured::max_residual, Measured::rms_residual);
  const LaneOptions lanes{true, *rc::gen::elementOf(std::vector<std::string_view>(
                                    lane_level_names().begin(), lane_level_names().end()))};
  WalkerResolver resolver(any.framework, technique, options, lanes);
  resolver.resolve(walkers, found, root, step, measured);
  for (std::size_t k = 0; k < alone.size(); ++k) {
    RC_ASSERT(same(together[k], alone[k]));
    expect_same(expected[k], found[k], measured);
  }
}

}  // namespace walker_random_law_test
}  // namespace pliant
