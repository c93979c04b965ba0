// SPDX-License-Identifier: MIT
// Loops redrawn between their ends: closure by itself, and on a bundle of three helices.
#include "pliant/sample/loops/loop_closure.hpp"

#include "pliant/base/math/axis_angle.hpp"
#include "pliant/base/math/normal.hpp"
#include "pliant/sample/loops/loop_moves.hpp"
#include "support/frameworks.hpp"
#include "support/source_folder.hpp"
#include "support/test.hpp"
#include "unit/jobs/sampled_molecules.hpp"

namespace pliant::loops_test {

constexpr double degree = std::numbers::pi / 180.0;

/// Points one step apart along random directions, and the axes between them.
struct Chain {
  std::vector<Vec3> points{{}};
  std::vector<LoopAxis> axes;

  Chain(std::size_t length, std::uint64_t seed) {
    RandomSequence draws({seed, Domain::generate, 0, 0, 0});
    for (std::size_t k = 0; k < length; ++k) {
      const Vec3 along = draws.direction();
      axes.push_back({points.back(), along});
      points.push_back(points.back() + 1.5 * along);
    }
  }

  /// The points after turns: each is moved by the axes that lie before it.
  std::vector<Vec3> turned(std::span<const RigidMotion> motions) const {
    std::vector<Vec3> out{points.front()};
    for (std::size_t k = 0; k < motions.size(); ++k) out.push_back(motions[k](points[k + 1]));
    return out;
  }
};

const LoopWishes no_wishes = [](std::span<const double>, std::span<double>) {};

TEST(LoopClosure, TurnsAboutOneAxisAsInClosedForm) {
  LoopClosure closure({{{1, 0, 0}, {0, 0, 1}}}, {2, 0, 0});
  const double turns[] = {0.5 * std::numbers::pi};
  const Vec3 at = closure.motions(turns).back()({2, 0, 0});
  EXPECT_LT(distance(at, {1, 1, 0}), 1e-14);
  // The end has moved by the root of two, and turned by half of pi over 3 Angstrom.
  EXPECT_NEAR(closure.gap(), std::hypot(std::sqrt(2.0), 1.5 * std::numbers::pi), 1e-12);
}

TEST(LoopClosure, BringsTheEndBackAndKeepsLengthsAndAngles) {
  int closed = 0;
  for (const std::size_t length : {8U, 12U, 20U, 30U})
    for (std::uint64_t seed = 0; seed < 25; ++seed) {
      const Chain chain(length, seed);
      LoopClosure closure(chain.axes, chain.points.back());
      RandomSequence draws({seed, Domain::loop, length, 0, 0});
      std::vector<double> turns(length);
      for (double& turn : turns) turn = draws.uniform() - 0.5;
      const std::vector<double> drawn = turns;
      if (!closure.close(turns, no_wishes)) continue;
      ++closed;
      const auto motions = closure.motions(turns);
      const std::vector<Vec3> now = chain.turned(motions);
      for (const Vec3 end : {chain.points.back(), chain.points.back() + Vec3{3, -2, 1}})
        EXPECT_LT(distance(motions.back()(end), end), 1e-9);
      for (std::size_t k = 0; k + 1 < now.size(); ++k)
        EXPECT_NEAR(distance(now[k], now[k + 1]), 1.5, 1e-9);
      for (std::size_t k = 0; k + 2 < now.size(); ++k)
        EXPECT_NEAR(distance(now[k], now[k + 2]), distance(chain.points[k], chain.points[k + 2]),
                    1e-9);
      EXPECT_NE(drawn, turns);
    }
  EXPECT_GT(closed, 80);
}

TEST(LoopClosure, LeavesWhatIsClosedAndTellsWhatCannotBe) {
  const Chain chain(12, 3);
  LoopClosure closure(chain.axes, chain.points.back());
  std::vector<double> turns(12, 0.0);
  EXPECT_TRUE(closure.close(turns, no_wishes));
  for (const double turn : turns) EXPECT_NEAR(turn, 0.0, 1e-12);
  // Two turns about one line cannot move the end in all six ways.
  LoopClosure line({{{}, {0, 0, 1}}, {{0, 0, 1}, {0, 0, 1}}}, {1, 0, 0});
  std::vector<double> two{0.5, 0.25};
  EXPECT_FALSE(line.close(two, no_wishes));
}

TEST(LoopTorsions, AreDrawnMostlyInTheRegions) {
  for (const auto kind : {LoopResidueKind::general, LoopResidueKind::before_proline,
                          LoopResidueKind::glycine, LoopResidueKind::proline}) {
    RandomSequence draws({7, Domain::loop, 0, 0, 0});
    int inside = 0;
    for (int k = 0; k < 1000; ++k) inside += loop_reach(kind, draw_phi_psi(kind, draws)) <= 1.0;
    EXPECT_GT(inside, 800) << int(kind);
  }
  const PhiPsi left{75 * degree, -150 * degree};
  EXPECT_GT(loop_reach(LoopResidueKind::general, left), 1.5);
  EXPECT_LT(loop_reach(LoopResidueKind::glycine, left), 1.0);
  const BackboneTurn back = loop_turn(LoopResidueKind::general, left, 1.0);
  EXPECT_NEAR(loop_reach(LoopResidueKind::general, {left.phi + back.phi, left.psi + back.psi}), 1.0,
              1e-9);
}

const MolecularModel& bundle() {
  static const MolecularModel model = [] {
    const Structure structure = test::bonded(source_folder() / "data/proteins/three_helices.pdb");
    return build_model(structure, {.kind = usual_model(structure)});
  }();
  return model;
}

PhiPsi torsions_at(const LoopResidue& at, std::span<const Vec3> x) {
  return {torsion_angle(x[at.before], x[at.n], x[at.ca], x[at.c]),
          torsion_angle(x[at.n], x[at.ca], x[at.c], x[at.behind])};
}

double omega_at(const LoopResidue& at, const LoopResidue& next, std::span<const Vec3> x) {
  return torsion_angle(x[at.ca], x[at.c], x[next.n], x[next.ca]);
}

TEST(LoopMoves, KeepBarsOmegaAndAllElse) {
  const Framework& framework = bundle().framework;
  const auto plan = BodyPlan::make(framework);
  const LoopMoves moves(framework, *plan, bundle().positions);
  ASSERT_FALSE(moves.empty());
  const auto residues = moves.residues();
  std::size_t redrawn = 0;
  std::set<std::size_t> lengths;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    std::vector<Vec3> x = bundle().positions;
    RandomSequence draws({seed, Domain::loop, 0, 0, 0});
    const std::vector<LoopSegment> done = moves.redraw(draws, most_loops, x);
    ASSERT_LE(done.size(), most_loops);
    redrawn += done.size();
    std::vector<bool> may_move(framework.atoms()->residues.size(), false);
    for (const LoopSegment& one : done) {
      lengths.insert(one.last - one.first);
      for (std::size_t k = one.first; k < one.last; ++k) {
        may_move[residues[k].residue] = true;
        const PhiPsi now = torsions_at(residues[k], x);
        EXPECT_LE(loop_reach(residues[k].kind, now), residues[k].reach + 1e-6);
        if (!residues[k].has_phi) EXPECT_NEAR(now.phi, residues[k].start.phi, 1e-9);
        EXPECT_NEAR(omega_at(residues[k], residues[k + 1], x),
                    omega_at(residues[k], residues[k + 1], bundle().positions), 1e-8);
      }
    }
    for (Joint joint = 0; joint < x.size(); ++joint)
      if (!may_move[framework.atoms()->residue_of[joint]])
        EXPECT_EQ(x[joint], bundle().positions[joint]);
    for (BarIndex b = 0; b < framework.bar_count(); ++b) {
      const Bar bar = framework.bars()[b];
      EXPECT_NEAR(distance(x[bar.a], x[bar.b]), framework.rest_lengths()[b], 1e-9);
    }
  }
  EXPECT_GT(redrawn, 40U);
  EXPECT_GE(lengths.size(), 5U);
}

TEST(LoopMoves, AreOfFewContactsAndOfThePlaceAlone) {
  const auto plan = BodyPlan::make(bundle().framework);
  std::vector<bool> in_place(bundle().framework.atoms()->residues.size(), false);
  const LoopMoves none(bundle().framework, *plan, bundle().positions, in_place);
  EXPECT_TRUE(none.empty());
  std::vector<Vec3> x = bundle().positions;
  RandomSequence draws({0, Domain::loop, 0, 0, 0});
  EXPECT_TRUE(none.redraw(draws, most_loops, x).empty());
  EXPECT_EQ(x, bundle().positions);

  const LoopMoves all(bundle().framework, *plan, bundle().positions);
  const LoopSegment& one = all.segments().front();
  in_place[all.residues()[one.first].residue] = true;
  const LoopMoves some(bundle().framework, *plan, bundle().positions, in_place);
  EXPECT_LT(some.segments().size(), all.segments().size());
  for (const LoopSegment& segment : some.segments()) {
    EXPECT_LE(segment.first, one.first);
    EXPECT_GT(segment.last, one.first);
    double contacts = 0.0;
    for (std::size_t k = segment.first; k < segment.last; ++k)
      contacts += some.residues()[k].contacts;
    EXPECT_LE(contacts, double(segment.last - segment.first));
  }
}

TEST(LoopMoves, LeaveWhatAMetalHolds) {
  const auto plan = BodyPlan::make(bundle().framework);
  const LoopMoves all(bundle().framework, *plan, bundle().positions);
  const LoopResidue& held = all.residues()[all.segments().front().first + 2];
  const Joint other = all.residues().front().ca;
  FrameworkParts parts = bundle().framework.parts();
  parts.limits.push_back({.a = held.parts[1].front(), .b = other, .kind = LimitKind::metal});
  const Framework framework(std::move(parts));
  const LoopMoves moves(framework, *plan, bundle().positions);
  EXPECT_LT(moves.segments().size(), all.segments().size());
  for (const LoopSegment& segment : moves.segments())
    for (std::size_t k = segment.first; k < segment.last; ++k)
      EXPECT_NE(moves.residues()[k].residue, held.residue);
}

}  // namespace pliant::loops_test
