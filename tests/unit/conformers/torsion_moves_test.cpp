// SPDX-License-Identifier: MIT
// What moves in molecules, and that every move keeps every bar.
#include "pliant/conformers/torsions/torsion_moves.hpp"

#include "pliant/conformers/torsions/loop_equations.hpp"
#include "pliant/conformers/torsions/small_sterics.hpp"
#include "pliant/conformers/torsions/torsion_draws.hpp"
#include "support/frameworks.hpp"
#include "support/test.hpp"
#include "unit/jobs/sampled_molecules.hpp"

namespace pliant::torsion_moves_test {

struct Molecule {
  explicit Molecule(const char* file)
      : model(test::model_of(file)),
        framework(conformer_framework(model.framework, model.positions)),
        plan(*conformer_plan(framework, model.positions)),
        moves(framework, plan, model.positions) {}

  double worst_bar(std::span<const Vec3> x) const { return test::worst_bar(framework, x); }

  MolecularModel model;
  Framework framework;
  BodyPlan plan;
  TorsionMoves moves;
};

TEST(TorsionMoves, ButaneTurnsAboutItsMiddleBond) {
  const Molecule butane("butane.sdf");
  ASSERT_EQ(butane.moves.rotors().size(), 1U);  // methyls look the same however they turn
  EXPECT_EQ(butane.moves.rotors()[0].kind, BondTurn::alkyl);
  EXPECT_TRUE(butane.moves.rings().empty());
  EXPECT_EQ(butane.moves.loop_bodies(), 0U);
  std::vector<Vec3> x = butane.model.positions;
  RandomSequence draws({.seed = 1});
  butane.moves.turn_rotors(draws, TorsionDraw::uniform, x);
  EXPECT_GT(test::largest_difference(x, butane.model.positions), 0.01);
  EXPECT_LT(butane.worst_bar(x), 1e-12);
}

TEST(TorsionMoves, WhatIsRigidIsEmpty) {
  EXPECT_TRUE(Molecule("benzene.sdf").moves.empty());
  const Molecule adamantane("adamantane.mol");
  EXPECT_TRUE(adamantane.moves.empty());
  ASSERT_EQ(adamantane.moves.rigid_rings().size(), 1U);
  EXPECT_EQ(adamantane.moves.rigid_rings()[0].size(), 10U);
}

TEST(TorsionMoves, RingsTakeFormsWithEveryBar) {
  const Molecule chair("cyclohexane_chair.xyz");
  ASSERT_EQ(chair.moves.rings().size(), 1U);
  RandomSequence draws({.seed = 1});
  double furthest = 0.0;
  for (int k = 0; k < 8; ++k) {
    std::vector<Vec3> x = chair.model.positions;
    chair.moves.draw_rings(draws, x);
    furthest = std::max(furthest, test::largest_difference(x, chair.model.positions));
    EXPECT_LT(chair.worst_bar(x), 1e-9);
  }
  EXPECT_GT(furthest, 0.5);
}

/// The steps of a draw close the loop to rounding.
TEST(TorsionMoves, LoopsAreDrawnAndClosed) {
  const Molecule crown("crown_18_6.cif");
  EXPECT_GT(crown.moves.loop_bodies(), 6U);
  EXPECT_EQ(crown.moves.bent(), nullptr);
  RandomSequence draws({.seed = 1});
  for (const TorsionDraw how : {TorsionDraw::uniform, TorsionDraw::preferred}) {
    std::vector<Vec3> x = crown.model.positions;
    crown.moves.draw_loops(draws, how, x);
    EXPECT_GT(test::largest_difference(x, crown.model.positions), 0.5);
    EXPECT_LT(crown.worst_bar(x), 1e-9);
  }
}

/// A pyramid of ammonia: what moves goes through the plane of the other two bonds.
TEST(TorsionMoves, InvertingTurnsToTheOtherSide) {
  const std::vector<Vec3> before{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.5, -0.5, 0.7}};
  std::vector<Vec3> x = before;
  invert({0, 1, 2, {3}}, x);
  EXPECT_NEAR(norm(x[3]), norm(before[3]), 1e-12);
  EXPECT_NEAR(distance(x[3], x[1]), distance(before[3], before[1]), 1e-12);
  EXPECT_NEAR(distance(x[3], x[2]), distance(before[3], before[2]), 1e-12);
  EXPECT_NEAR(x[3].z, -0.7, 1e-12);
}

TEST(TorsionMoves, AnAmideTurnsByHalfACircle) {
  const std::vector<Vec3> before{{0, 0, 0}, {1.3, 0, 0}, {2.0, 1.2, 0.1}};
  std::vector<Vec3> x = before;
  turn_over({0, 1, {2}}, x);
  EXPECT_NEAR(distance(x[2], {2.0, -1.2, -0.1}), 0.0, 1e-12);
}

TEST(SmallSterics, SumsSquaresOfDepths) {
  const Framework framework({.joint_count = 3, .sterics = test::spheres(3, 3.0)});
  const SmallSterics small(framework);
  EXPECT_EQ(small.pairs().size(), 3U);
  const std::vector<Vec3> near{{0, 0, 0}, {2, 0, 0}, {0, 2.5, 0}};
  EXPECT_NEAR(small.overlap(near, 9.0), 1.25, 1e-12);
  EXPECT_EQ(small.overlap(near, 1.0), 1.0);  // which is enough
  EXPECT_EQ(small.overlap(std::vector<Vec3>{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, 9.0), 0.0);
  EXPECT_TRUE(SmallSterics(Framework({.joint_count = 3})).pairs().empty());
}

/// It once read elements that were not there.
TEST(ConformerFramework, OfJointsWithoutNamesIsTheFrameworkItself) {
  const MolecularModel butane = test::model_of("butane.sdf");
  FrameworkParts parts = butane.framework.parts();
  parts.atoms = nullptr;
  const Framework nameless(std::move(parts));
  ASSERT_NE(nameless.sterics(), nullptr);
  const Framework made = conformer_framework(nameless, butane.positions);
  EXPECT_EQ(made.bar_count(), nameless.bar_count());
  EXPECT_EQ(made.sterics()->own, nameless.sterics()->own);
}

TEST(ConformerFramework, AnglesOfRingsBecomeLimits) {
  const MolecularModel chair = test::model_of("cyclohexane_chair.xyz");
  const Framework made = conformer_framework(chair.framework, chair.positions);
  EXPECT_EQ(made.bar_count() + 30, chair.framework.bar_count());
  ASSERT_EQ(made.limits().size(), 30U);
  for (const Limit& limit : made.limits()) {
    const double length = distance(chair.positions[limit.a], chair.positions[limit.b]);
    EXPECT_NEAR(limit.least, length - 0.12, 1e-12);
    EXPECT_NEAR(limit.most, length + 0.12, 1e-12);
  }
}

constexpr double degree = std::numbers::pi / 180.0;

double degrees(Turn turn) {
  return std::fmod(std::atan2(turn.sine, turn.cosine) / degree + 360.0, 360.0);
}

Turn of(double angle) { return {std::cos(angle * degree), std::sin(angle * degree)}; }

/// From the nearest peak, in its widths.
double off_usual(double angle, const BondTurnEntry& row) {
  double least = 180.0;
  for (const TorsionPeak& peak : row.peaks)
    for (const double sign : {-1.0, 1.0})
      least =
          std::min(least, std::abs(std::remainder(angle - sign * peak.angle, 360.0)) / peak.width);
  return least;
}

TEST(TorsionDraws, TurnsAddUp) {
  EXPECT_NEAR(degrees(of(80) * of(300)), 20.0, 1e-9);
  EXPECT_NEAR(degrees(of(80) * back(of(30))), 50.0, 1e-9);
  EXPECT_NEAR(degrees(of_half_tangent(std::tan(35 * degree))), 70.0, 1e-9);
}

TEST(TorsionDraws, UsualOnesLieWhereTheTableSaysAndReachAllOfIt) {
  for (const BondTurnEntry& row : bond_turns()) {
    SCOPED_TRACE(row.name);
    EXPECT_EQ(row.name, entry(row.kind).name);
    if (stays(row.kind)) continue;
    RandomSequence draws({.seed = 3});
    std::vector<int> seen(row.peaks.size());
    int usual = 0;
    for (int k = 0; k < 4000; ++k) {
      const double angle = degrees(drawn_usual(draws, row.kind));
      if (off_usual(angle, row) < 0.8) ++usual;
      for (std::size_t m = 0; m < seen.size(); ++m)
        if (off_usual(angle, {row.kind, row.name, row.peaks.subspan(m, 1)}) < 0.8) ++seen[m];
    }
    EXPECT_GT(usual, 3100);
    for (const int count : seen) EXPECT_GT(count, 0);
  }
}

TEST(TorsionDraws, EnergiesAreLowestAtPeaksAndRiseBetween) {
  for (const BondTurnEntry& row : bond_turns()) {
    SCOPED_TRACE(row.name);
    double lowest = 9.0;
    for (int angle = -180; angle < 180; ++angle) {
      const double energy = torsion_energy(row.kind, of(angle));
      lowest = std::min(lowest, energy);
      EXPECT_LT(energy, 6.5);
      EXPECT_NEAR(energy, torsion_energy(row.kind, of(-angle)), 1e-9);
      EXPECT_NEAR(energy, torsion_energy(row.kind, of(angle + 1)), 0.5);
    }
    EXPECT_NEAR(lowest, 0.0, 0.01);
  }
  EXPECT_NEAR(torsion_energy(BondTurn::alkyl, of(64)), 0.9, 0.02);
  EXPECT_GT(torsion_energy(BondTurn::biaryl_flanked, of(0)), 3.0);
  EXPECT_EQ(torsion_energy(BondTurn::any, of(17)), 0.0);
}

TEST(TorsionDraws, AnglesAreAnyEvenly) {
  RandomSequence draws({.seed = 4});
  int quarters[4] = {};
  for (int k = 0; k < 4000; ++k) {
    const Turn turn = drawn_angle(draws);
    EXPECT_NEAR(turn.cosine * turn.cosine + turn.sine * turn.sine, 1.0, 1e-12);
    ++quarters[static_cast<int>(degrees(turn) / 90.0) % 4];
  }
  for (int quarter : quarters) EXPECT_NEAR(quarter, 1000, 5 * std::sqrt(750.0));
}

TEST(TorsionDraws, TheNearestUsualOne) {
  EXPECT_NEAR(degrees(nearest_usual(of(80), BondTurn::alkyl)), 64.0, 1e-9);
  EXPECT_NEAR(degrees(nearest_usual(of(125), BondTurn::alkyl)), 180.0, 1e-9);
  EXPECT_NEAR(degrees(nearest_usual(of(299), BondTurn::biaryl_flanked)), 290.0, 1e-9);
  EXPECT_NEAR(degrees(nearest_usual(of(77), BondTurn::ester)), 77.0, 1e-9);
}

/// Place 2 lies 2 Angstrom from the axis of the hinge, which is z; it turns towards y.
const std::vector<Vec3> places{{0, 0, -1}, {0, 0, 1}, {2, 0, 0}};
const LoopHinge hinge{0, 1, 2, 3};

/// The turn that is least of damping d^2 + weight (off + slope d)^2.
double closed_form(double off, double slope, double weight, double damping) {
  return -weight * slope * off / (weight * slope * slope + damping);
}

void add_row(LoopEquations& equations, Slot place, Vec3 slope, double off, double weight) {
  equations.begin_row();
  equations.add_to_row(place, slope);
  equations.end_row(off, weight);
}

TEST(LoopEquations, OneHingeTurnsByTheClosedForm) {
  LoopEquations equations({&hinge, 1});
  equations.begin(places, 0.5);
  add_row(equations, 2, {0, 3, 7}, 0.1, 4.0);  // the slope is 2 * 3: along z turns nothing
  const auto turns = equations.solve();
  ASSERT_EQ(turns.size(), 1U);
  EXPECT_NEAR(turns[0], closed_form(0.1, 6.0, 4.0, 0.5), 1e-15);
}

TEST(LoopEquations, RowsAddUpAndWhatDoesNotTurnDoesNotCount) {
  LoopEquations equations({&hinge, 1});
  equations.begin(places, 1.0);
  for (int k = 0; k < 3; ++k) add_row(equations, 2, {0, 1, 0}, 0.2, 1.0);
  add_row(equations, 0, {5, 5, 5}, 9.0, 9.0);
  EXPECT_NEAR(equations.solve()[0], closed_form(0.2, 2.0, 3.0, 1.0), 1e-15);
}

TEST(LoopEquations, DampingGrowsByAShareOfTheDiagonal) {
  LoopEquations equations({&hinge, 1});
  equations.begin(places, 0.0);
  add_row(equations, 2, {0, 1, 0}, 1.0, 1.0);
  equations.add_damping(0.25);  // of 4
  EXPECT_NEAR(equations.solve()[0], closed_form(1.0, 2.0, 1.0, 1.0), 1e-15);
}

TEST(LoopEquations, ThereIsNoSolutionWithoutRowsOrDamping) {
  LoopEquations equations({&hinge, 1});
  equations.begin(places, 0.0);
  EXPECT_TRUE(equations.solve().empty());
}

}  // namespace pliant::torsion_moves_test
