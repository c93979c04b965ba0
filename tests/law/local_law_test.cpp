// SPDX-License-Identifier: MIT
// Laws of steps that look only at a region around a push, for rigid units with and without
// contacts: all is whole, what is far stays to the bit, near stays near, and neither history nor
// size changes anything.
#include "pliant/framework/measures/neighbour_list.hpp"
#include "pliant/lab/examples/examples.hpp"
#include "pliant/resolve/resolve.hpp"
#include "pliant/run/run.hpp"
#include "support/frameworks.hpp"
#include "support/molecules.hpp"
#include "support/test.hpp"

namespace pliant::local_law_test {

using test::Molecule;

/// Spheres of 2.6 Angstrom between heavy atoms and 1.8 with hydrogens, and cables between every
/// ninth atom and those near it: a dense net of contacts, as a model of a protein is.
Molecule molecule(const std::string& file, bool has_contacts) {
  const Structure structure = test::bonded(molecule_file(file));
  BuildOptions options{.bars = BarKind::angles};
  if (has_contacts) {
    auto sterics =
        std::make_shared<Sterics>(Sterics{.kind_count = 2, .least = {2.6, 1.8, 1.8, 1.6}});
    for (auto element : structure.atoms.elements) sterics->kinds.push_back(element == 1 ? 1 : 0);
    options.sterics = sterics;
    const Framework bare = build_framework(structure, options);
    sterics->own = own_distances(bare, structure.positions);
    for (Joint a = 0; a < structure.size(); a += 9)
      for (Joint b = a + 30; b < structure.size(); b += 9)
        if (const double d = distance(structure.positions[a], structure.positions[b]);
            d < 6.0 && d > 3.5)
          options.limits.push_back({a, b, 0.0, d + 0.05, LimitKind::given, 0.0, no_limit_group});
  }
  return {build_framework(structure, options), structure.positions};
}

struct Case {
  const char* technique;
  bool has_contacts;
};
constexpr Case cases[] = {
    {"units", false}, {"auto", false}, {"froda", false}, {"froda", true}, {"auto", true}};

template <class Look>
void each_case(const Look& look) {
  for (const Case& c : cases)
    for (const char* file : {"peptide_20.pdb", "cyclic_hexapeptide.pdb", "cholesterol.cif"}) {
      SCOPED_TRACE(std::string(c.technique) + (c.has_contacts ? ", contacts, " : ", ") + file);
      const Molecule m = molecule(file, c.has_contacts);
      look(m, c.technique);
    }
}

Vec3 push_of(std::uint64_t step, double size) {
  return size * RandomSequence({9, Domain::force, 0, step, 0}).direction();
}

Joint pushed_at(const Molecule& m, std::uint64_t step) {
  return static_cast<Joint>((41 * step) % m.framework.joint_count());
}

TEST(LocalLaw, AllIsWholeAndWhatIsFarStays) {
  each_case([](const Molecule& m, const char* technique) {
    Resolver resolver(m.framework, {technique}, {{1e-10}, 200});
    for (std::uint64_t step = 0; step < 25; ++step) {
      const Joint root = pushed_at(m, step);
      std::vector<Vec3> x = m.start;
      x[root] += push_of(step, step % 3 == 0 ? 0.4 : 0.04);
      const std::vector<Vec3> pushed = x;
      const ResolveSummary summary = resolver.resolve_near(x, root, std::int64_t(step), m.start);
      EXPECT_TRUE(summary.converged());
      const ResidualSummary all = measure(m.framework, x, {1e-10});
      EXPECT_TRUE(all.within) << all.max_relative << " " << all.max_limit << " " << all.max_overlap;
      EXPECT_LE(test::largest_difference(x, pushed), 4.0 * distance(pushed[root], m.start[root]));
      const auto moved = resolver.moved();
      if (!moved) continue;
      std::vector<std::uint8_t> may_move(x.size(), 0);
      for (Joint joint : *moved) may_move[joint] = 1;
      for (Joint joint = 0; joint < x.size(); ++joint)
        EXPECT_TRUE(may_move[joint] != 0 || joint == root || x[joint] == m.start[joint]);
    }
  });
}

/// Lists of near joints are kept from step to step; what comes out is as if they were made anew.
TEST(LocalLaw, HistoryChangesNoBit) {
  each_case([](const Molecule& m, const char* technique) {
    Resolver kept(m.framework, {technique}, {{1e-10}, 200});
    std::vector<Vec3> x = m.start;
    for (std::uint64_t step = 0; step < 40; ++step) {
      const std::vector<Vec3> before = x;
      const Joint root = pushed_at(m, step);
      x[root] += push_of(step, 0.3);
      std::vector<Vec3> y = x;
      const std::vector<Joint> joints{root};
      kept.resolve(x, {root, false, joints, step > 0}, std::int64_t(step), before);
      Resolver(m.framework, {technique}, {{1e-10}, 200})
          .resolve(y, {root, false, joints}, std::int64_t(step), before);
      ASSERT_TRUE(test::same_bits(x, y)) << step;
    }
  });
}

/// Rounding of many steps does not add up.
TEST(LocalLaw, BarsStayExactInLongRuns) {
  for (const char* technique : {"units", "froda"}) {
    const Molecule m = molecule("peptide_20.pdb", std::string(technique) == "froda");
    State state(m.start);
    const RunSummary summary =
        run(m.framework, state, {.technique = {technique}, .steps = 3000, .every = 3000}, {});
    EXPECT_EQ(summary.unconverged_steps, 0) << technique;
    EXPECT_LT(test::worst_bar(m.framework, state.positions), 1e-12) << technique;
    EXPECT_GT(test::largest_difference(state.positions, m.start), 0.5) << technique;
  }
}

/// A region would not keep the centre of mass.
TEST(LocalLaw, WithMassesTheWholeIsResolved) {
  const Molecule m = molecule("peptide_20.pdb", true);
  for (bool mass_weighted : {false, true}) {
    std::vector<Vec3> x = m.start;
    x[40] += push_of(0, 0.3);
    Resolver resolver(m.framework, {"froda", 0.5, mass_weighted});
    EXPECT_TRUE(resolver.resolve_near(x, 40, 1, m.start).converged());
    EXPECT_EQ(resolver.moved().has_value(), !mass_weighted);
  }
}

/// The same region, whatever is beyond it.
TEST(LocalLaw, AStepCostsAsMuchInALongerChain) {
  std::int64_t visits[2];
  for (std::size_t k = 0; k < 2; ++k) {
    const Sketch sketch = with_angles(shaken(chain(k == 0 ? 300 : 30'000), 0.25));
    const Framework framework = framework_of(sketch);
    std::vector<Vec3> x = sketch.positions;
    x[150] += {0.02, 0.03, -0.05};
    const ResolveSummary summary =
        Resolver(framework, {"units"}).resolve_near(x, 150, 1, sketch.positions);
    EXPECT_TRUE(summary.converged());
    visits[k] = summary.projections;
  }
  EXPECT_EQ(visits[0], visits[1]);
  EXPECT_LT(visits[0], 300);
}

/// What holds a small region back is moved, too, in the end: a pull is followed however far.
TEST(LocalLaw, ALastingPullIsFollowed) {
  const Molecule m = molecule("peptide_20.pdb", false);
  std::vector<Vec3> x = m.start;
  Resolver resolver(m.framework, {"units"}, {{1e-8}, 200});
  const Vec3 goal = m.start[0] + Vec3{60, 0, 0};
  for (std::int64_t step = 0; step < 1000; ++step) {
    const std::vector<Vec3> before = x;
    const Vec3 way = goal - x[0];
    x[0] += std::min(1.0, 0.5 / norm(way)) * way;
    ASSERT_TRUE(resolver.resolve_near(x, 0, step, before).converged());
  }
  EXPECT_LT(distance(x[0], goal), 20.0);
}

/// In a long chain that is all stretched out a push is mostly taken back; it never breaks anything.
TEST(LocalLaw, AStretchedChainStaysWhole) {
  const std::size_t joints = 8000;
  Sketch sketch = with_angles(chain(joints));
  for (std::size_t k = 0; k < joints; ++k)
    sketch.positions[k] = {1.26 * double(k), k % 2 == 0 ? 0.0 : 0.87, 0.0};
  sketch = with_angles([&] {
    Sketch bare = chain(joints);
    bare.positions = sketch.positions;
    return bare;
  }());
  const Framework framework = framework_of(sketch);
  Resolver resolver(framework, {"units"}, {{1e-8}, 200});
  std::vector<Vec3> x = sketch.positions;
  for (std::int64_t step = 0; step < 20; ++step) {
    const std::vector<Vec3> before = x;
    const auto root = static_cast<Joint>(3000 + 100 * step);
    x[root] += push_of(std::uint64_t(step), 0.3);
    const std::vector<Vec3> pushed = x;
    EXPECT_TRUE(resolver.resolve_near(x, root, step, before).converged());
    EXPECT_TRUE(resolver.moved());
    EXPECT_LE(test::largest_difference(x, pushed), 0.31);
  }
  EXPECT_TRUE(is_whole(framework, x, {1e-8}));
}

}  // namespace pliant::local_law_test
