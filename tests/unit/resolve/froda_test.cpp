// SPDX-License-Identifier: MIT
#include "pliant/resolve/bodies/froda.hpp"

#include "pliant/resolve/bodies/pull/froda_solver.hpp"
#include "support/frameworks.hpp"
#include "support/molecules.hpp"
#include "support/test.hpp"

namespace pliant::froda_test {

using test::molecule;
using test::Molecule;

/// The same with spheres.
Molecule with_spheres(const std::string& file, double least,
                      const std::vector<OwnDistance>& own = {}) {
  auto sterics = test::spheres(molecule(file).framework.joint_count(), least);
  sterics->own = own;
  return molecule(file, {.sterics = sterics});
}

/// Each joint belongs to one body, which comes after the one it hangs on; a forest needs no cuts.
TEST(BodyPlan, EveryJointBelongsToOneBody) {
  test::each_molecule([](const Molecule& m) {
    const auto plan = BodyPlan::make(m.framework);
    ASSERT_TRUE(plan);
    EXPECT_EQ(plan->place_count(), m.framework.joint_count() + plan->cuts().size());
    for (Joint joint = 0; joint < m.framework.joint_count(); ++joint)
      EXPECT_EQ(plan->joint_at()[plan->place_of(joint)], joint);
    for (std::size_t k = 0; k < plan->bodies().size(); ++k)
      EXPECT_LT(plan->bodies()[k].parent, static_cast<std::int32_t>(k));
  });
}

/// However hard the push, bonds and angles stay: also where loops were cut.
TEST(FrodaSolver, BarsStayWholeWhateverThePush) {
  test::each_molecule([](const Molecule& m) {
    const auto plan = BodyPlan::make(m.framework);
    FrodaSolver solver(m.framework, *plan);
    std::vector<Vec3> out = m.start;
    for (double size : {0.0, 0.3, 1.0}) {
      const auto pushed = test::shake(m.framework, m.start, size, 4);
      const FrodaResult result = solver.resolve(m.start, pushed, out);
      EXPECT_TRUE(result.is_whole) << size;
      EXPECT_LT(test::worst_bar(m.framework, out), 1e-10) << size;
      EXPECT_LE(result.max_closing, 0.3) << size;
    }
  });
}

/// Without contacts torsions alone follow the push: nothing else could come nearer than the best
/// turn of the one bond of hydrogen peroxide's like, found by trying.
TEST(FrodaSolver, OneTorsionGoesWhereItFitsBest) {
  FrameworkParts parts{.joint_count = 4,
                       .bars = {{0, 1}, {1, 2}, {0, 2}, {2, 3}, {1, 3}},
                       .drawn = {{0, 1, 0}, {0, 0, 0}, {1.4, 0, 0}, {1.4, 1, 0}}};
  for (Bar bar : parts.bars)
    parts.rest_lengths.push_back(distance(parts.drawn[bar.a], parts.drawn[bar.b]));
  const Framework framework(parts);
  const auto plan = BodyPlan::make(framework);
  FrodaSolver solver(framework, *plan);
  std::vector<Vec3> target = parts.drawn, out = target;
  target[3] = {1.4, std::cos(0.6), std::sin(0.6)};
  target[0] = {0, std::cos(0.2), -std::sin(0.2)};
  for (int again = 0; again < 200; ++again) {
    const std::vector<Vec3> now = out;
    solver.resolve(now, target, out);
  }
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(distance(out[k], target[k]), 0.0, 1e-6) << k;
}

/// So many copies of a molecule side by side, of which no joints touch.
Molecule copies_of(const Molecule& one, std::size_t count) {
  FrameworkParts parts = test::copies_of(one.framework, one.start, count, {60, 0, 0}).parts();
  const std::vector<Vec3> start = std::exchange(parts.drawn, {});
  auto sterics = test::spheres(parts.joint_count, 1.9);
  parts.sterics = sterics;
  sterics->own = own_distances(Framework(parts), start);
  return {Framework(std::move(parts)), start};
}

/// What a push of one joint of one molecule takes: bodies that steps looked at.
FrodaResult result_of_drag(const Molecule& m, Joint joint) {
  const auto plan = BodyPlan::make(m.framework);
  FrodaSolver solver(m.framework, *plan);
  std::vector<Vec3> target = m.start, out = m.start;
  target[joint] += Vec3{0.2, 0.1, 0.3};
  const FrodaResult result = solver.resolve(m.start, target, out);
  EXPECT_GT(distance(out[joint], m.start[joint]), 1e-3);
  for (std::size_t k = m.start.size() / 2; k < m.start.size(); ++k)
    EXPECT_NEAR(distance(out[k], m.start[k]), 0.0, 1e-12) << k;
  return result;
}

/// Molecules that nothing touches cost no step of a drag anything, however many they are.
TEST(FrodaSolver, ADragLooksAtTheMoleculeThatIsDraggedAlone) {
  const Molecule one = molecule("cyclic_hexapeptide.pdb");
  const Joint joint = 20;
  const std::size_t many = 10'000 / one.framework.joint_count() + 1;
  const FrodaResult few = result_of_drag(copies_of(one, 2), joint);
  const FrodaResult all = result_of_drag(copies_of(one, many), joint);
  EXPECT_TRUE(all.is_whole);
  EXPECT_EQ(few.steps, all.steps);
  EXPECT_EQ(few.visits, all.visits);
  EXPECT_LE(all.visits, all.steps * std::int64_t(one.framework.joint_count()));
}

/// Two argon atoms on one place but for a little part; a limit pulls two others together.
TEST(FrodaSolver, HoldsSpheresApartAndLimitsTogether) {
  const Framework framework({.joint_count = 4,
                             .limits = {{2, 3, 0.0, 5.0, LimitKind::given, 0.0, no_limit_group}},
                             .sterics = test::spheres(4, 3.0)});
  const std::vector<Vec3> start{{0, 0, 0}, {4, 0, 0}, {0, 20, 0}, {5, 20, 0}};
  const std::vector<Vec3> target{{0, 0, 0}, {0.5, 0, 0}, {0, 20, 0}, {9, 20, 0}};
  const auto plan = BodyPlan::make(framework);
  FrodaSolver solver(framework, *plan);
  std::vector<Vec3> out = start;
  const FrodaResult result = solver.resolve(start, target, out);
  EXPECT_TRUE(result.is_whole);
  EXPECT_GE(distance(out[0], out[1]), 3.0 - 0.02);
  EXPECT_LE(distance(out[2], out[3]), 5.0 + 0.02);
  const std::vector<std::uint8_t> off{1};
  solver.resolve(start, target, out, {}, off);
  EXPECT_NEAR(distance(out[2], out[3]), 9.0, 1e-3);
}

/// Where the slots of a plan are if joints are at `positions`.
std::vector<Vec3> places_of(const BodyPlan& plan, std::span<const Vec3> positions) {
  std::vector<Vec3> places;
  for (Joint joint : plan.joint_at()) places.push_back(positions[joint]);
  return places;
}

/// What the list has of pairs that are too near, beside a look at all pairs; how many there are.
std::size_t expect_all_found(const NearPairs& list, const Framework& framework,
                             const BodyPlan& plan, std::span<const Vec3> x) {
  const LeastDistances rules(framework);
  std::size_t listed = 0, expected = 0;
  for (const NearPair& pair : list.pairs()) {
    const Joint a = plan.joint_at()[pair.i], b = plan.joint_at()[pair.j];
    EXPECT_EQ(pair.least, rules.of(std::min(a, b), std::max(a, b)));
    listed += distance(x[pair.i], x[pair.j]) < pair.least;
  }
  for (Joint a = 0; a < framework.joint_count(); ++a)
    for (Joint b = a + 1; b < framework.joint_count(); ++b) {
      const Slot i = plan.place_of(a), j = plan.place_of(b);
      expected += plan.body_at()[i] != plan.body_at()[j] && distance(x[i], x[j]) < rules.of(a, b);
    }
  EXPECT_EQ(listed, expected);
  return expected;
}

/// Whether all joints move or one by one, so that but some pairs are listed anew.
TEST(NearPairs, AreThoseOfALookAtAllPairs) {
  const Molecule m = with_spheres("cyclic_hexapeptide.pdb", 3.1, {{0, 9, 0.5}, {3, 20, 0.0}});
  const auto plan = BodyPlan::make(m.framework);
  NearPairs list(m.framework, *plan);
  RandomSequence draws({11, Domain::generate});
  for (std::uint64_t seed = 1; seed < 6; ++seed) {
    SCOPED_TRACE(seed);
    const auto moved = test::shake(m.framework, m.start, 0.3 * double(seed), seed);
    std::vector<Vec3> x = places_of(*plan, moved);
    list.update(x);
    EXPECT_GT(expect_all_found(list, m.framework, *plan, x), 0u);
    for (int again = 0; again < 40; ++again) {
      x[draws.below(x.size())] += 0.35 * draws.direction();
      list.update(x);
      expect_all_found(list, m.framework, *plan, x);
    }
  }
}

/// So many joints move, some out of all cells, that cells are sorted again now and then.
TEST(NearPairs, AreThoseOfALookAtAllPairsWhileManyMove) {
  const Molecule m = copies_of(molecule("cyclic_hexapeptide.pdb"), 8);
  ASSERT_GT(m.start.size(), 2 * NearCells::most_moved);
  const auto plan = BodyPlan::make(m.framework);
  NearPairs list(m.framework, *plan);
  RandomSequence draws({12, Domain::generate});
  std::vector<Vec3> x = places_of(*plan, m.start);
  list.update(x);
  for (int again = 0; again < 20; ++again) {
    for (int k = 0; k < 70; ++k) x[draws.below(x.size())] += 0.6 * draws.direction();
    list.update(x);
    EXPECT_GT(expect_all_found(list, m.framework, *plan, x), 0u);
  }
}

/// Places that are back where the list was first made have that list again, which is not made anew.
TEST(NearPairs, KeepTheFirstList) {
  const Molecule m = with_spheres("peptide_20.pdb", 3.1);
  const auto plan = BodyPlan::make(m.framework);
  NearPairs list(m.framework, *plan);
  list.update(places_of(*plan, m.start));
  for (std::uint64_t seed = 1; seed < 4; ++seed) {
    const auto far = places_of(*plan, test::shake(m.framework, m.start, 0.8, seed));
    list.update(far);
    expect_all_found(list, m.framework, *plan, far);
    const auto made = list.lists_made();
    const auto back = places_of(*plan, test::shake(m.framework, m.start, 0.02, seed));
    list.update(back);
    EXPECT_EQ(list.lists_made(), made);
    expect_all_found(list, m.framework, *plan, back);
    auto some = back;  // then but some pairs are listed anew
    for (std::size_t k = 0; k < some.size(); k += 5) some[k] += Vec3{0.4, 0.0, 0.0};
    list.update(some);
    EXPECT_GT(list.lists_made(), made);
    expect_all_found(list, m.framework, *plan, some);
  }
}

/// Careful pulls on the way look at contacts as often as asked; those to the last target are blind
/// once, and then weigh contacts more each time.
TEST(FrodaFrame, CarefulPullsWeighContactsMoreEachTime) {
  const Molecule m = with_spheres("peptide_20.pdb", 3.0);
  const auto plan = BodyPlan::make(m.framework);
  std::vector<Vec3> target = m.start;
  for (std::size_t k = 0; k < target.size() / 2; ++k) target[k] += Vec3{9.0, 0.0, 0.0};
  const auto weights = [&](int legs_a_look) {
    const FrodaOptions options{.is_careful = true, .legs_a_look = legs_a_look};
    FrodaFrame frame(m.framework, *plan);
    frame.begin({m.start, target}, options);
    EXPECT_EQ(frame.legs(), 5);
    ArticulatedStep step(*plan, frame.working());
    std::vector<double> found;
    while (frame.ask_for_careful_pull()) {
      const auto rows = frame.request().rows;
      found.push_back(rows.empty() ? 0.0 : rows.front().weight);
      step.step(frame.positions(), frame.request());
      frame.note_step();
    }
    return found;
  };
  EXPECT_EQ(weights(1), (std::vector<double>{0, 10, 10, 10, 10, 20, 40, 80}));
  EXPECT_EQ(weights(2), (std::vector<double>{0, 0, 10, 0, 10, 20, 40, 80}));
  EXPECT_EQ(weights(9), (std::vector<double>{0, 0, 0, 0, 0, 20, 40, 80}));
}

/// A small push needs no pull with contacts, which would hold it back, and few without.
TEST(FrodaSolver, ASmallPushTakesFewSteps) {
  const Molecule m = copies_of(molecule("peptide_20.pdb"), 1);
  const auto plan = BodyPlan::make(m.framework);
  FrodaSolver solver(m.framework, *plan);
  std::vector<Vec3> out = m.start;
  const auto steps_of = [&](double size) {
    return solver.resolve(m.start, test::shake(m.framework, m.start, size, 4), out).steps;
  };
  EXPECT_LE(steps_of(0.05), 4);
  EXPECT_GE(steps_of(0.5), 3);
}

/// The technique, from any push and without knowing where bars were whole.
TEST(Froda, ResolvesFrameworksWithLimitsAndSterics) {
  const Molecule m = with_spheres("cyclic_hexapeptide.pdb", 2.0);
  std::vector<Vec3> x = test::shake(m.framework, m.start, 0.2, 3);
  const ResolveOptions options{.tolerance = {.overlap = 0.1}};
  const ResolveSummary summary = resolve(m.framework, {"froda"}, x, options);
  EXPECT_TRUE(summary.converged()) << summary.brief(m.framework);
  EXPECT_TRUE(measure(m.framework, x, options.tolerance).within);
}

}  // namespace pliant::froda_test
