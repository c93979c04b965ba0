// SPDX-License-Identifier: MIT
// What a resolve must not depend on, and what it must conserve; linkages of the plane stay in it.
#include "law/technique_cases.hpp"
#include "pliant/framework/measures/residual.hpp"

namespace pliant::symmetry_law_test {

class SymmetryLaw : public test::TechniqueLaw {};

/// A small break is mended on the near side: no bar comes out pointing the other way ("wrong root
/// of the constraint equation").
TEST_P(SymmetryLaw, NoBarIsReversed) {
  each_case([](const Example& example, const Technique& technique) {
    if (!example.facts.whole) return;
    std::vector<Vec3> x =
        test::shake(example.framework, example.positions, test::small_break(example.framework));
    const ResolveOptions options{.max_sweeps = 200};
    if (!resolve(example.framework, technique, x, options).converged()) return;
    for (Bar bar : example.framework.bars())
      EXPECT_GT(dot(x[bar.b] - x[bar.a], example.positions[bar.b] - example.positions[bar.a]), 0.0)
          << example.framework.label(bar);
  });
}

/// With shares by inverse mass and half and half besides, each projection keeps the centre of mass;
/// what goes outward is shifted back.
TEST_P(SymmetryLaw, MassWeightingKeepsTheCentreOfMass) {
  each_example([](const Example& example) {
    if (example.framework.has_pinned_joints() || example.positions.empty()) return;
    const Framework framework = test::with_masses(example.framework);
    std::vector<Vec3> x = test::shake(framework, example.positions, 0.2);
    const Vec3 before = test::centre_of_mass(framework, x);
    const ResolveOptions options{.max_sweeps = 50};
    Technique technique = plain();
    technique.mass_weighted = true;
    resolve(framework, technique, x, options);
    EXPECT_LT(distance(test::centre_of_mass(framework, x), before), 1e-12 * test::extent(x));
  });
}

/// Rotating and shifting first or last makes no difference, up to rounding. A few sweeps only:
/// rounding grows in frameworks that do not converge.
TEST_P(SymmetryLaw, RigidMotionsPassThrough) {
  each_case([](const Example& example, const Technique& technique) {
    if (example.name.starts_with("coincident")) return;  // part in a direction of their own
    if (example.framework.sterics()) return;  // which of equal overlaps counts, rounding decides
    // A direct method divides by what redundant bars make vanish.
    if (!GetParam().has_weighting && example.facts.rank != example.framework.bar_count()) return;
    std::vector<Vec3> x =
        test::shake(example.framework, example.positions, test::small_break(example.framework));
    std::vector<Vec3> moved = test::moved_rigidly(x);
    const ResolveOptions options{.max_sweeps = 5};
    const ResolveSummary here = resolve(example.framework, technique, x, options);
    const ResolveSummary there = resolve(example.framework, technique, moved, options);
    EXPECT_EQ(here.sweeps, there.sweeps);
    EXPECT_EQ(here.stop, there.stop);
    EXPECT_LT(test::largest_difference(test::moved_rigidly(x), moved), 1e-9 * test::extent(x));
  });
}

/// Which end of a bar is named first changes no bit where corrections are shared half and half;
/// and none at any weighting for orderings that are traversals (order_law_test holds those to it).
TEST_P(SymmetryLaw, SwappingBarEndsChangesNothing) {
  const bool starts_at_first_joint = GetParam().name == "random" || GetParam().name == "input";
  each_case([&](const Example& example, const Technique& technique) {
    if (starts_at_first_joint && technique.weighting != 0.5) return;
    if (example.name.starts_with("coincident") && starts_at_first_joint) return;
    std::vector<Vec3> x = test::shake(example.framework, example.positions, 0.1);
    std::vector<Vec3> y = x;
    const ResolveOptions options{.max_sweeps = 20};
    const Framework swapped = test::with_swapped_ends(example.framework);
    const ResolveSummary as_given = resolve(example.framework, technique, x, options);
    const ResolveSummary as_swapped = resolve(swapped, technique, y, options);
    EXPECT_EQ(as_given.sweeps, as_swapped.sweeps);
    EXPECT_TRUE(test::same_bits(x, y));
  });
}

/// The same input gives the same bits, from a new resolver and from one that has been used with
/// other positions, roots and steps.
TEST_P(SymmetryLaw, SameInputSameBits) {
  each_case([](const Example& example, const Technique& technique) {
    if (example.positions.empty()) return;
    const ResolveOptions options{.max_sweeps = 12};
    const auto last = static_cast<Joint>(example.positions.size() - 1);
    const std::vector<Vec3> start = test::shake(example.framework, example.positions, 0.2);
    std::vector<Vec3> first = start, other = test::shake(example.framework, start, 0.3);
    Resolver fresh(example.framework, technique, options);
    const ResolveSummary one = fresh.resolve(first, last, 5);
    Resolver used(example.framework, technique, options);
    used.resolve(other, 0, 1);
    used.resolve(other, last, 9);
    std::vector<Vec3> second = start;
    const ResolveSummary two = used.resolve(second, last, 5);
    EXPECT_TRUE(test::same_bits(first, second));
    EXPECT_EQ(one.sweeps, two.sweeps);
    EXPECT_EQ(one.projections, two.projections);
  });
}

/// Lengths and positions a million times larger or smaller (by powers of two: exactly) give the
/// same sweeps and the same bits but for the exponent.
TEST_P(SymmetryLaw, ScaleDoesNotMatter) {
  each_case([](const Example& example, const Technique& technique) {
    if (!example.framework.has_bars_only()) return;  // the tolerance of limits is a length
    if (example.name.starts_with("coincident")) return;
    const std::vector<Vec3> start =
        test::shake(example.framework, example.positions, test::small_break(example.framework));
    const ResolveOptions options{.max_sweeps = 8};
    std::vector<Vec3> expected = start;
    const ResolveSummary plain_size = resolve(example.framework, technique, expected, options);
    for (double scale : {0x1p20, 0x1p-20}) {
      FrameworkParts parts = test::parts_of(example.framework);
      for (double& length : parts.rest_lengths) length *= scale;
      std::vector<Vec3> x = start;
      for (Vec3& p : x) p *= scale;
      const ResolveSummary scaled = resolve(Framework(std::move(parts)), technique, x, options);
      for (Vec3& p : x) p *= 1.0 / scale;
      EXPECT_EQ(scaled.sweeps, plain_size.sweeps);
      EXPECT_TRUE(test::same_bits(x, expected));
    }
  });
}

PLIANT_FOR_ALL_TECHNIQUES(SymmetryLaw);

class PlaneLaw : public test::TechniqueLaw {};

Framework planar(const Framework& framework) {
  FrameworkParts parts = test::parts_of(framework);
  parts.planar = true;
  return Framework(std::move(parts));
}

/// Each joint moved by `size` in a direction of the plane.
std::vector<Vec3> pushed(const Framework& framework, std::span<const Vec3> positions, double size) {
  std::vector<Vec3> x(positions.begin(), positions.end());
  for (Joint joint = 0; joint < x.size(); ++joint)
    if (!framework.is_pinned(joint))
      x[joint] +=
          size * framework.random_direction(RandomSequence({1, Domain::force, 0, 0, joint}));
  return x;
}

bool is_flat(std::span<const Vec3> positions) {
  for (const Vec3& x : positions)
    if (x.z != 0.0) return false;
  return true;
}

TEST_P(PlaneLaw, FrameworksOfThePlaneStayInIt) {
  std::size_t seen = 0;
  each_case([&](const Example& example, const Technique& technique) {
    if (!is_flat(example.positions) || !example.framework.has_bars_only()) return;
    const Framework framework = planar(example.framework);
    ++seen;
    for (double size : {1e-3, 0.05, 1.0}) {
      std::vector<Vec3> x = pushed(framework, example.positions, size);
      resolve(framework, technique, x, {{}, 50});
      EXPECT_TRUE(is_flat(x)) << "pushed by " << size;
    }
  });
  EXPECT_GT(seen, 0u);
}

PLIANT_FOR_ALL_TECHNIQUES(PlaneLaw);

/// Two triangles with three bars between them, parallel ones and such as meet in a point.
TEST(Plane, PrismsAreMadeWholeByWhateverAutoTakes) {
  for (const Example& example : examples()) {
    if (!example.name.starts_with("prism_2D")) continue;
    const Framework framework = planar(example.framework);
    for (double size : {1e-3, 0.05}) {
      std::vector<Vec3> x = pushed(framework, example.positions, size);
      EXPECT_TRUE(resolve(framework, {"auto"}, x).converged()) << example.name << " " << size;
    }
  }
}

}  // namespace pliant::symmetry_law_test
