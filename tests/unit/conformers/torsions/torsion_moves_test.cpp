// SPDX-License-Identifier: MIT
// What moves in molecules, and that every move keeps every bar.
#include "pliant/conformers/torsions/torsion_moves.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "pliant/conformers/torsions/small_sterics.hpp"
#include "support/frameworks.hpp"
#include "unit/jobs/sampled_molecules.hpp"

namespace pliant {
namespace torsion_moves_test {

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
  FrameworkParts parts;
  parts.joint_count = 3;
  auto sterics = std::make_shared<Sterics>();
  sterics->kind_count = 1;
  sterics->kinds = {0, 0, 0};
  sterics->least = {3.0};
  parts.sterics = sterics;
  const Framework framework(parts);
  const SmallSterics small(framework);
  EXPECT_EQ(small.pairs().size(), 3U);
  EXPECT_NEAR(small.overlap(std::vector<Vec3>{{0, 0, 0}, {2, 0, 0}, {0, 2.5, 0}}), 1.25, 1e-12);
  EXPECT_EQ(small.overlap(std::vector<Vec3>{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}), 0.0);
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

}  // namespace torsion_moves_test
}  // namespace pliant
