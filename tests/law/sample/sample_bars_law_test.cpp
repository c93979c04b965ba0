// SPDX-License-Identifier: MIT
// Every bar of every frame is whole, and so is every bond and, where angles are held, every angle
// of the structure, whatever the framework says. There atoms keep their handedness, and double
// bonds and amides stay cis or trans. Conformers may turn tertiary amides over, and invert nitrogen
// that bears three atoms.
#include "law/sample/sample_cases.hpp"
#include "pliant/model/atoms/atom_graph.hpp"
#include "support/frameworks.hpp"
#include "support/test.hpp"

namespace pliant::sample_bars_law_test {

constexpr double whole = 1e-9;  // of a bar's length

class SampleBarsLaw : public test::SampleLaw {};
PLIANT_FOR_ALL_SAMPLERS(SampleBarsLaw);

TEST_P(SampleBarsLaw, AllAreWholeAsReported) {
  each_frame([](const test::SampleCase&, const SampleTask& task, const test::KeptFrame& frame) {
    EXPECT_TRUE(test::all_finite(frame.positions));
    const double worst = test::worst_bar(task.framework(), frame.positions);
    EXPECT_LE(worst, whole);
    EXPECT_NEAR(frame.max_residual, worst, 1e-14);
  });
}

double change(std::uint32_t a, std::uint32_t b, std::span<const Vec3> x, std::span<const Vec3> y) {
  const double before = distance(x[a], x[b]);
  return std::abs(distance(y[a], y[b]) - before) / before;
}

/// The framework of conformers lets angles of rings give way.
TEST_P(SampleBarsLaw, BondsAndAnglesAreThoseOfTheStart) {
  each_frame([](const test::SampleCase& at, const SampleTask& task, const test::KeptFrame& frame) {
    const Structure& structure = test::model_of(at).structure;
    for (const Bond& bond : structure.bonds)
      EXPECT_LE(change(bond.a, bond.b, task.start(), frame.positions), whole);
    if (models()[at.model].bars == BarKind::bonds || !sampler().has_amplitude) return;
    const AtomGraph graph(structure);
    for (std::uint32_t atom = 0; atom < structure.size(); ++atom)
      for (const Link& one : graph.at(atom))
        for (const Link& other : graph.at(atom))
          EXPECT_LE(one.node == other.node
                        ? 0.0
                        : change(one.node, other.node, task.start(), frame.positions),
                    whole);
  });
}

constexpr double pyramidal = 0.3;  // of bonds of length 1; 0.77 where they are tetrahedral
constexpr double twist = 5.0;      // degrees

class SampleHandednessLaw : public test::SampleLaw {
 protected:
  /// Calls `look(case, graph, start, frame)` where angles are held.
  template <class Look>
  static void each_held_frame(Look look) {
    each_frame(
        [&](const test::SampleCase& at, const SampleTask& task, const test::KeptFrame& frame) {
          if (models()[at.model].bars == BarKind::bonds) return;
          look(test::model_of(at).structure, AtomGraph(test::model_of(at).structure), task.start(),
               std::span<const Vec3>(frame.positions));
        });
  }
};
PLIANT_FOR_ALL_SAMPLERS(SampleHandednessLaw);

Vec3 along(std::span<const Vec3> x, std::uint32_t from, std::uint32_t to) {
  const Vec3 bond = x[to] - x[from];
  return (1.0 / norm(bond)) * bond;
}

/// Of the first three bonds of an atom.
double volume(std::span<const Vec3> x, std::uint32_t atom, std::span<const Link> bonds) {
  return dot(cross(along(x, atom, bonds[0].node), along(x, atom, bonds[1].node)),
             along(x, atom, bonds[2].node));
}

TEST_P(SampleHandednessLaw, AtomsKeepTheirs) {
  std::size_t seen = 0;
  each_held_frame([&](const Structure& structure, const AtomGraph& graph,
                      std::span<const Vec3> start, std::span<const Vec3> x) {
    for (std::uint32_t atom = 0; atom < x.size(); ++atom) {
      const auto bonds = graph.at(atom);
      const std::size_t least = sampler().has_amplitude ? 3 : 4;
      if (bonds.size() < least || std::abs(volume(start, atom, bonds)) < pyramidal) continue;
      ++seen;
      EXPECT_GT(volume(start, atom, bonds) * volume(x, atom, bonds), 0.0)
          << structure.atoms.label(atom);
    }
  });
  EXPECT_GT(seen, 0U);
}

/// Degrees, from 0 to 360.
double torsion(std::span<const Vec3> x, std::array<std::uint32_t, 4> at) {
  const Vec3 axis = along(x, at[1], at[2]);
  const Vec3 one = cross(x[at[0]] - x[at[1]], axis), other = cross(x[at[3]] - x[at[2]], axis);
  const double angle = std::atan2(dot(cross(one, other), axis), dot(one, other));
  return std::fmod(angle * 180.0 / std::numbers::pi + 360.0, 360.0);
}

struct StiffBond {
  std::array<std::uint32_t, 4> at;
  bool turns_over;  ///< as a whole, in conformers
};

/// Bonds C-N of amides (`carbon` bears an O that bears nothing else), and those of order 2 between
/// carbons.
std::vector<StiffBond> stiff_bonds(const Structure& structure, const AtomGraph& graph) {
  const auto element = [&](std::uint32_t atom) { return structure.atoms.elements[atom]; };
  const auto other_of = [&](std::uint32_t atom, std::uint32_t except) {
    const auto bonds = graph.at(atom);
    return std::find_if(bonds.begin(), bonds.end(),
                        [&](const Link& at) { return at.node != except; })
        ->node;
  };
  const auto ends_oxygen = [&](const Link& at) {
    return element(at.node) == 8 && graph.at(at.node).size() == 1;
  };
  std::vector<StiffBond> found;
  for (const Bond& bond : structure.bonds) {
    const auto [a, b] = std::pair(bond.a, bond.b);
    if (graph.at(a).size() < 3 || graph.at(b).size() < 3) continue;
    const std::uint32_t carbon = element(a) == 6 ? a : b, other = carbon == a ? b : a;
    if (element(carbon) != 6) continue;
    const auto at_carbon = graph.at(carbon);
    const bool is_amide = element(other) == 7 && graph.at(other).size() == 3 &&
                          std::any_of(at_carbon.begin(), at_carbon.end(), ends_oxygen);
    if (!is_amide && !(element(other) == 6 && bond.order == 2)) continue;
    const std::array<std::uint32_t, 4> four{other_of(a, b), a, b, other_of(b, a)};
    found.push_back({four, is_amide && graph.hydrogens_at(other) == 0});
  }
  return found;
}

TEST_P(SampleHandednessLaw, DoubleBondsAndAmidesStayCisOrTrans) {
  std::size_t seen = 0;
  each_held_frame([&](const Structure& structure, const AtomGraph& graph,
                      std::span<const Vec3> start, std::span<const Vec3> x) {
    for (const StiffBond& bond : stiff_bonds(structure, graph)) {
      ++seen;
      const double turned =
          std::fmod(torsion(x, bond.at) - torsion(start, bond.at) + 540.0, 360.0) - 180.0;
      const bool is_over = bond.turns_over && !sampler().has_amplitude && std::abs(turned) > 90.0;
      EXPECT_NEAR(std::abs(turned), is_over ? 180.0 : 0.0, twist)
          << structure.atoms.label(bond.at[1]) << " - " << structure.atoms.label(bond.at[2]);
    }
  });
  EXPECT_GT(seen, 0U);
}

}  // namespace pliant::sample_bars_law_test
