// SPDX-License-Identifier: MIT
// What the summary of a resolve may say, whatever the technique.
#include "law/technique_cases.hpp"
#include "pliant/framework/measures/residual.hpp"
#include "support/rigidity.hpp"
#include "support/test.hpp"

namespace pliant::outcome_law_test {

class OutcomeLaw : public test::TechniqueLaw {};

/// The summary tells what measure() finds; nothing is ever called converged beyond the tolerance,
/// nothing is left broken with sweeps to spare, and no position stops being a number.
TEST_P(OutcomeLaw, TheSummaryIsTrue) {
  each_case([](const Example& example, const Technique& technique) {
    const ResolveOptions options{.max_sweeps = 60};
    for (double size : {test::small_break(example.framework), 2.0}) {
      std::vector<Vec3> x = test::shake(example.framework, example.positions, size);
      const ResolveSummary summary = resolve(example.framework, technique, x, options);
      const ResidualSummary found = measure(example.framework, x, options.tolerance);
      EXPECT_TRUE(test::all_finite(x));
      EXPECT_EQ(summary.converged(), found.within);
      EXPECT_EQ(summary.stop, found.within ? Stop::converged : Stop::max_sweeps);
      EXPECT_EQ(summary.max_residual, found.max_relative);
      EXPECT_EQ(summary.rms_residual, found.rms_relative);
      EXPECT_EQ(summary.worst_bar, found.worst_bar);
      EXPECT_LE(summary.sweeps, options.max_sweeps);
      EXPECT_GE(summary.seconds, 0.0);
      EXPECT_TRUE(found.within || summary.sweeps == options.max_sweeps);
    }
  });
}

/// Where the bars are independent, and not nearly dependent, a small break is mended. The error
/// falls by about the square of the least singular value a sweep: 0.1 asks for 1400 sweeps.
TEST_P(OutcomeLaw, IndependentBarsConverge) {
  each_example([](const Example& example) {
    if (!example.facts.whole || example.positions.empty()) return;
    if (test::least_singular_value(example.framework, example.positions) < 0.1) return;
    for (bool mass_weighted : {false, true}) {
      const Framework framework = test::with_masses(example.framework);
      std::vector<Vec3> x = test::shake(framework, example.positions, test::small_break(framework));
      Technique technique = plain();
      technique.mass_weighted = mass_weighted;
      const ResolveSummary summary = resolve(framework, technique, x);
      EXPECT_TRUE(summary.converged()) << summary.brief(framework);
      EXPECT_LE(summary.max_residual, 1e-6);
    }
  });
}

/// What cannot be is never called converged, from near or far.
TEST_P(OutcomeLaw, TheImpossibleNeverConverges) {
  each_case([](const Example& example, const Technique& technique) {
    if (example.facts.feasible) return;
    const ResolveOptions options{.tolerance = {.relative = 1e-3}, .max_sweeps = 500};
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
      std::vector<Vec3> x = test::shake(example.framework, example.positions, 0.3, seed);
      const ResolveSummary summary = resolve(example.framework, technique, x, options);
      EXPECT_EQ(summary.stop, Stop::max_sweeps);
      EXPECT_GT(summary.max_residual, 1e-3);
      EXPECT_TRUE(test::all_finite(x));
    }
  });
}

/// Bars that are whole stay bit for bit, and nothing is counted.
TEST_P(OutcomeLaw, TheWholeIsLeftUntouched) {
  each_case([](const Example& example, const Technique& technique) {
    if (!example.facts.whole) return;
    std::vector<Vec3> x = example.positions;
    const ResolveSummary summary = resolve(example.framework, technique, x);
    EXPECT_TRUE(summary.converged());
    EXPECT_EQ(summary.sweeps, 0);
    EXPECT_EQ(summary.projections, 0);
    EXPECT_TRUE(test::same_bits(x, example.positions));
  });
}

/// The limit is met exactly, and each sweep looks at each bar once.
TEST_P(OutcomeLaw, TheLimitOfSweepsIsKept) {
  const Example& example = find_example("pinned_ends_too_far_12");
  for (std::int64_t limit : {1, 2, 3, 17}) {
    const ResolveOptions options{.max_sweeps = limit};
    std::vector<Vec3> x = example.positions;
    const ResolveSummary summary = resolve(example.framework, plain(), x, options);
    EXPECT_EQ(summary.stop, Stop::max_sweeps);
    EXPECT_EQ(summary.sweeps, limit);
    EXPECT_EQ(summary.projections, 10 * limit);
  }
}

TEST_P(OutcomeLaw, TheCallerCanStopItAfterASweep) {
  const Example& example = find_example("pinned_ends_too_far_12");
  int asked = 0;
  const ResolveOptions options{.should_stop = [&] { return ++asked == 3; }};
  std::vector<Vec3> x = example.positions;
  const ResolveSummary summary = resolve(example.framework, plain(), x, options);
  EXPECT_EQ(summary.stop, Stop::stopped_by_caller);
  EXPECT_EQ(summary.sweeps, 3);
  EXPECT_EQ(summary.max_residual, measure(example.framework, x).max_relative);
}

/// A length that overflows is reported, and the positions are put back.
TEST_P(OutcomeLaw, OverflowPutsThePositionsBack) {
  const Framework framework = framework_of(chain(6));
  for (double far : {1e200, 1e308, -1.7e308}) {
    std::vector<Vec3> x = chain(6).positions;
    x[3].y = far;
    const std::vector<Vec3> before = x;
    const ResolveSummary summary = resolve(framework, plain(), x);
    EXPECT_EQ(summary.stop, Stop::not_finite);
    EXPECT_TRUE(test::same_bits(x, before));
    EXPECT_TRUE(summary.worst_bar >= 1 && summary.worst_bar <= 4) << summary.worst_bar;
  }
}

TEST_P(OutcomeLaw, NotANumberIsToldAndPutBack) {
  const Framework framework = framework_of(chain(4));
  std::vector<Vec3> x = chain(4).positions;
  x[1].x = std::nan("");
  const std::vector<Vec3> before = x;
  EXPECT_EQ(resolve(framework, plain(), x).stop, Stop::not_finite);
  EXPECT_TRUE(test::same_bits(x, before));
}

/// Joints that lie on each other part in a direction that the seed decides.
TEST_P(OutcomeLaw, CoincidentJointsPart) {
  for (const char* name : {"coincident_pair", "coincident_star", "coincident_ring"}) {
    const Example& example = find_example(name);
    if (!applies_to(example)) continue;
    SCOPED_TRACE(name);
    std::vector<std::vector<Vec3>> ends;
    for (std::uint64_t seed : {1, 1, 2}) {
      const ResolveOptions options{.seed = seed};
      std::vector<Vec3> x = example.positions;
      const ResolveSummary summary = resolve(example.framework, plain(), x, options);
      EXPECT_TRUE(summary.converged()) << summary.brief(example.framework);
      ends.push_back(x);
    }
    EXPECT_TRUE(test::same_bits(ends[0], ends[1]));
    EXPECT_FALSE(test::same_bits(ends[0], ends[2]));
  }
}

TEST_P(OutcomeLaw, PinnedJointsDoNotMove) {
  each_case([](const Example& example, const Technique& technique) {
    const std::size_t count = example.framework.joint_count();
    if (count < 2) return;
    const auto last = static_cast<Joint>(count - 1);
    for (const std::vector<Joint>& pinned :
         {std::vector<Joint>{0}, std::vector<Joint>{last}, std::vector<Joint>{0, last}}) {
      const Framework framework = test::with_pinned(example.framework, pinned);
      std::vector<Vec3> x = test::shake(framework, example.positions, 0.1);
      const ResolveOptions options{.max_sweeps = 20};
      const std::vector<Vec3> before = x;
      resolve(framework, technique, x, options, last);
      for (Joint joint : pinned) EXPECT_EQ(x[joint], before[joint]);
    }
  });
}

PLIANT_FOR_ALL_TECHNIQUES(OutcomeLaw);

}  // namespace pliant::outcome_law_test
