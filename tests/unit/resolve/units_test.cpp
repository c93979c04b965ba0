// SPDX-License-Identifier: MIT
#include "pliant/resolve/bodies/units.hpp"

#include "pliant/lab/examples/examples.hpp"
#include "pliant/resolve/bodies/outward/loop_closure.hpp"
#include "pliant/resolve/bodies/tree/body_plan.hpp"
#include "support/frameworks.hpp"
#include "support/molecules.hpp"
#include "support/test.hpp"

namespace pliant::units_test {

using test::molecule;
using test::Molecule;

/// What stays after drawn positions are taken away.
Framework without_drawing(const Framework& framework) {
  return Framework(test::parts_of(framework));
}

/// Whole after one pass from a shake.
void expect_one_pass(const Framework& framework, std::span<const Vec3> start, double by,
                     std::uint64_t seed, double tolerance = 1e-12, Joint root = 0) {
  std::vector<Vec3> x = test::shake(framework, start, by, seed);
  const ResolveSummary summary = resolve(framework, {"units"}, x, {{tolerance}}, root);
  EXPECT_TRUE(summary.converged()) << summary.brief(framework);
  EXPECT_EQ(summary.sweeps, 1);
  for (Joint joint = 0; joint < x.size(); ++joint)
    EXPECT_TRUE(!framework.is_pinned(joint) || x[joint] == start[joint]);
}

/// All bonds and angles held: every molecule is whole after one pass, far or near, whatever hangs
/// on whatever. Rings of more than six atoms close by iteration, to the tolerance.
TEST(Units, EveryMoleculeIsWholeAfterOnePass) {
  std::size_t exact = 0;
  test::each_molecule([&](const Molecule& m) {
    const bool has_large_rings = !BodyPlan::make(m.framework)->cuts().empty();
    exact += !has_large_rings;
    for (double by : {0.1, 0.3})
      for (std::uint64_t seed = 1; seed <= 5; ++seed)
        expect_one_pass(m.framework, m.start, by, seed, has_large_rings ? 1e-8 : 1e-12);
  });
  EXPECT_GE(exact, 14u);
}

/// A chain of a thousand units is as exact at its end as at its beginning.
TEST(Units, ErrorsDoNotAddUpAlongAChain) {
  const Sketch sketch = with_angles(shaken(chain(3000), 0.2));
  const Framework framework = framework_of(sketch);
  std::vector<Vec3> x = test::shake(framework, sketch.positions, 0.3);
  const ResolveSummary summary = resolve(framework, {"units"}, x, {{1e-11}}, 1500);
  EXPECT_EQ(summary.stop, Stop::converged);
  EXPECT_EQ(summary.sweeps, 1);
  // Coordinates of 3000 Angstrom carry 13 digits after the point.
  EXPECT_LT(summary.max_residual, 1e-12);
}

double handedness(const std::vector<Vec3>& x, Joint centre, Joint a, Joint b, Joint c) {
  return dot(x[a] - x[centre], cross(x[b] - x[centre], x[c] - x[centre]));
}

/// Pushed so hard that centres turn inside out, they come back as drawn; lengths alone cannot tell.
TEST(Units, DrawnCentresKeepTheirHandedness) {
  const Molecule m = molecule("alanine_dipeptide.pdb");
  std::size_t turned = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    std::vector<Vec3> x = test::shake(m.framework, m.start, 1.0, seed);
    std::vector<Vec3> y = x;
    ASSERT_TRUE(resolve(m.framework, {"units"}, x).converged());
    ASSERT_TRUE(resolve(without_drawing(m.framework), {"units"}, y).converged());
    for (Joint centre = 0; centre < x.size(); ++centre) {
      std::vector<Joint> around;
      for (const Incidence& at : m.framework.neighbours(centre))
        if (distance(m.start[centre], m.start[at.joint]) < 1.7) around.push_back(at.joint);
      if (around.size() != 4) continue;
      const auto hand = [&](const std::vector<Vec3>& p) {
        return handedness(p, centre, around[0], around[1], around[2]);
      };
      EXPECT_NEAR(hand(x), hand(m.start), 1e-9);
      turned += hand(y) * hand(m.start) < 0.0;
    }
  }
  EXPECT_GT(turned, 0u) << "the push was too weak to test anything";
}

TEST(Units, LengthsAloneWillDoWhereBodiesAreComplete) {
  for (const char* file : {"butane.sdf", "ethane.xyz", "alanine_dipeptide.pdb"}) {
    const Molecule m = molecule(file);
    expect_one_pass(without_drawing(m.framework), m.start, 0.3, 1);
  }
}

/// An alkyne's carbons are on one line: the units between have no torsion to choose.
TEST(Units, StraightChainsAreWholeAfterOnePass) {
  Sketch butyne;
  butyne.positions = {{0, 0, 0}, {1.46, 0, 0}, {2.66, 0, 0}, {4.12, 0, 0}};
  butyne.bars = {{0, 1}, {1, 2}, {2, 3}};
  for (int k = 0; k < 3; ++k) {
    const double c = std::cos(2.0 * k), s = std::sin(2.0 * k);
    butyne.positions.push_back({-0.36, c, s});
    butyne.bars.push_back({0, Joint(butyne.positions.size() - 1)});
    butyne.positions.push_back({4.48, s, c});
    butyne.bars.push_back({3, Joint(butyne.positions.size() - 1)});
  }
  const Framework framework = framework_of(with_angles(butyne));
  for (std::uint64_t seed = 1; seed <= 10; ++seed)
    expect_one_pass(framework, butyne.positions, 0.2, seed);
}

TEST(Units, OnePassHoldsUpToTwoPinnedJointsOfOneUnit) {
  const Molecule m = molecule("butane.sdf");
  for (const std::vector<Joint>& pinned : {std::vector<Joint>{0}, std::vector<Joint>{0, 1}})
    expect_one_pass(test::with_pinned(m.framework, pinned), m.start, 0.2, 1, 1e-12, 7);
}

TEST(Units, PinnedJointsFarApartAreLeftToOthers) {
  const Molecule m = molecule("butane.sdf");
  const Framework framework = test::with_pinned(m.framework, {4, 13});
  std::vector<Vec3> x = test::shake(framework, m.start, 0.05);
  const ResolveSummary summary = resolve(framework, {"units"}, x);
  EXPECT_TRUE(summary.converged()) << summary.brief(framework);
  for (Joint joint : {4u, 13u}) EXPECT_EQ(x[joint], m.start[joint]);
}

/// Joints of a unit on the axis of its hinge, or all at one point: parted by chance, never NaN.
TEST(Units, JointsAtOnePointPart) {
  const Molecule m = molecule("ethane.xyz");
  for (bool all : {false, true}) {
    std::vector<Vec3> x = m.start;
    for (std::size_t k = all ? 0 : 5; k < x.size(); ++k) x[k] = x[1];
    const ResolveSummary summary = resolve(m.framework, {"units"}, x, {{1e-9}});
    EXPECT_TRUE(test::all_finite(x));
    EXPECT_TRUE(all || summary.converged()) << summary.brief(m.framework);
  }
}

/// Weighted by mass, a heavy atom of the first unit stays nearer to where it was.
TEST(Units, FitsMayBeWeightedByMass) {
  const Molecule m = molecule("ethane.xyz");
  std::vector<Vec3> plain = test::shake(m.framework, m.start, 0.2), heavy = plain;
  const std::vector<Vec3> before = plain;
  resolve(m.framework, {"units", 0.5, false}, plain);
  resolve(m.framework, {"units", 0.5, true}, heavy);
  EXPECT_LT(distance(heavy[0], before[0]), distance(plain[0], before[0]));
}

/// A crown of ten atoms between two chains, reached from the end of one: its shape is found before
/// the chain moves its joints.
TEST(Units, LoopsAreCarriedAlongByTheUnitsTheyHangOn) {
  Sketch sketch = ring(10);
  for (std::size_t k = 0; k < 10; ++k)
    sketch.positions[k].z = k % 3 == 0 ? 0.6 : 0.1 * double(k % 2);
  const Vec3 middle = 0.5 * (sketch.positions[0] + sketch.positions[5]);
  for (const Joint at : {0u, 5u}) {
    Joint last = at;
    for (int k = 0; k < 6; ++k) {
      const Vec3 out = sketch.positions[at] - middle;
      const double size = 1.0 / norm(out);
      sketch.positions.push_back(sketch.positions[last] +
                                 (k % 2 == 0 ? size * out : Vec3{0.3, 0.2, 0.9}));
      sketch.bars.push_back({last, Joint(sketch.positions.size() - 1)});
      last = Joint(sketch.positions.size() - 1);
    }
  }
  const Framework framework = framework_of(with_angles(sketch));
  for (const Joint root : {0u, 15u, 21u})
    for (std::uint64_t seed = 1; seed <= 5; ++seed)
      expect_one_pass(framework, sketch.positions, 0.1, seed, 1e-10, root);
}

double moved(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double sum = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += norm_squared(a[k] - b[k]);
  return sum;
}

/// One pass alone swings what hangs on a unit and lands farther.
TEST(Units, AFrodaThatBeginsAtThemLandsNearerToWhereThePushLeftTheJoints) {
  double all = 0.0, all_plain = 0.0;
  for (const char* file : {"peptide_20.pdb", "cholesterol.cif", "butane.sdf", "glucose.cif",
                           "aspirin.sdf", "alanine_dipeptide.pdb", "benzene.sdf"}) {
    const Molecule m = molecule(file);
    SCOPED_TRACE(file);
    for (double by : {0.1, 0.3})
      for (bool mass_weighted : {false, true}) {
        const std::vector<Vec3> start = test::shake(m.framework, m.start, by);
        std::vector<Vec3> x = start, plain = start;
        ASSERT_TRUE(resolve(m.framework, {"froda", 0.5, mass_weighted}, x, {{1e-12}}).converged());
        resolve(m.framework, {"units", 0.5, mass_weighted}, plain);
        if (mass_weighted) continue;
        EXPECT_LT(moved(x, start), moved(m.start, start) * 1.15);
        EXPECT_LE(moved(x, start), moved(plain, start) * (1.0 + 1e-9));
        all += moved(x, start);
        all_plain += moved(plain, start);
      }
  }
  EXPECT_LT(all, 0.3 * all_plain);
}

/// A puckered ring of n joints, with bars across its angles.
Sketch crown(std::size_t n, double height = 0.5) {
  Sketch sketch = ring(n);
  for (std::size_t k = 0; k < n; ++k)
    sketch.positions[k].z = height * std::cos(3.0 * 2.0 * std::numbers::pi * double(k) / double(n));
  return with_angles(sketch);
}

std::optional<LoopClosure> closure_of(const Framework& framework) {
  const UnitSet bodies = find_units(framework);
  return LoopClosure::make(bodies, find_unit_shapes(framework, bodies, {}),
                           connect_units(framework, bodies));
}

class LoopsOf : public testing::TestWithParam<std::size_t> {};

TEST_P(LoopsOf, CloseToRounding) {
  const Sketch sketch = crown(GetParam());
  const Framework framework = framework_of(sketch);
  auto closure = closure_of(framework);
  ASSERT_TRUE(closure);
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    std::vector<Vec3> x = test::shake(framework, sketch.positions, 0.1, seed);
    ASSERT_TRUE(closure->close(x, 1e-12)) << seed;
    EXPECT_LT(measure(framework, x).max_relative, 1e-11) << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(Joints, LoopsOf, testing::Values(8, 9, 12, 20, 60));

/// Two rings that share a joint, and a third on one of them: closed together.
TEST(LoopClosure, ClosesSeveralLoopsAtOnce) {
  Sketch sketch = crown(10);
  sketch.bars.resize(10);  // without those across angles, which come anew
  for (const Joint at : {0u, 5u}) {
    const Sketch other = crown(9);
    const auto first = static_cast<Joint>(sketch.positions.size());
    const Vec3 shift = sketch.positions[at] - other.positions[0];
    for (std::size_t k = 1; k < 9; ++k) {
      const Vec3 p = other.positions[k] - other.positions[0];
      const double side = at == 0 ? 1.0 : -1.0;
      sketch.positions.push_back(other.positions[0] + shift + Vec3{-side * p.x, p.z, p.y});
    }
    for (Joint k = first; k + 1 < first + 8; ++k) sketch.bars.push_back({k, k + 1});
    sketch.bars.push_back({at, first});
    sketch.bars.push_back({at, first + 7});
  }
  const Framework framework = framework_of(with_angles(sketch));
  auto closure = closure_of(framework);
  ASSERT_TRUE(closure);
  std::vector<Vec3> x = test::shake(framework, sketch.positions, 0.1);
  ASSERT_TRUE(closure->close(x, 1e-12));
  EXPECT_LT(measure(framework, x).max_relative, 1e-11);
}

/// One bar of an unbranched ring of eight taken much too long: angles and bonds cannot all be met.
TEST(LoopClosure, LeavesWhatCannotCloseAsItWas) {
  const Sketch sketch = crown(8);
  FrameworkParts parts = test::parts_of(framework_of(sketch));
  for (std::size_t k = 0; k < 4; ++k) parts.rest_lengths[k] = 0.6;
  for (std::size_t k = 4; k < 8; ++k) parts.rest_lengths[k] = 1.35;
  const Framework framework(std::move(parts));
  auto closure = closure_of(framework);
  ASSERT_TRUE(closure);
  std::vector<Vec3> x = test::shake(framework, sketch.positions, 0.05);
  const std::vector<Vec3> before = x;
  if (!closure->close(x, 1e-10)) {
    EXPECT_TRUE(test::same_bits(x, before));
  } else {
    EXPECT_LT(measure(framework, x).max_relative, 1e-9);
  }
  x[3].y = std::nan("");
  EXPECT_FALSE(closure->close(x, 1e-10));
}

TEST(LoopClosure, RefusesMoreLoopsThanDenseEquationsHold) {
  EXPECT_FALSE(closure_of(framework_of(shaken(grid(9, 9), 0.1))));
}

}  // namespace pliant::units_test
