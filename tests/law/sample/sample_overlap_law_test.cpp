// SPDX-License-Identifier: MIT
// No two atoms are nearer than the table of sterics says, where the model has one: pairs four bonds
// apart or more, all of them looked at, with least distances by the words of the pages.
#include <algorithm>
#include <limits>

#include "law/sample/sample_cases.hpp"
#include "pliant/model/atoms/atom_graph.hpp"
#include "pliant/model/steric_table.hpp"

namespace pliant {
namespace sample_overlap_law_test {

constexpr double kept = 0.08 + 1e-9;  // Angstrom, at which steps end

class SampleOverlapLaw : public test::SampleLaw {};
PLIANT_FOR_ALL_SAMPLERS(SampleOverlapLaw);

constexpr int far = 1000;  // no bonds lead there

/// Bonds from an atom to each other.
std::vector<int> bonds_from(std::uint32_t atom, const AtomGraph& graph, std::size_t atoms) {
  std::vector<int> apart(atoms, far);
  apart[atom] = 0;
  for (int step = 0; std::ranges::count(apart, step) > 0; ++step)
    for (std::uint32_t k = 0; k < atoms; ++k)
      if (apart[k] == step)
        for (const Link& bond : graph.at(k))
          apart[bond.node] = std::min(apart[bond.node], step + 1);
  return apart;
}

struct Pair {
  std::uint32_t a, b;
  double least;
};

/// Pairs that are nearer at the start keep the distance that they have there; heavy atoms of
/// conformers come nearer where they are four bonds apart, but none more than that to 2.68 Angstrom.
std::vector<Pair> pairs_of(const MolecularModel& model, bool is_soft) {
  const Sterics table = molecular_sterics(model.structure, false);
  const AtomGraph graph(model.structure);
  const std::size_t atoms = model.structure.size();
  std::vector<Pair> pairs;
  for (std::uint32_t a = 0; a < atoms; ++a) {
    const std::vector<int> apart = bonds_from(a, graph, atoms);
    for (std::uint32_t b = a + 1; b < atoms; ++b) {
      if (apart[b] <= 3) continue;
      const double usual = table.of_kinds(a, b);
      const double start = distance(model.positions[a], model.positions[b]);
      const bool are_heavy = !graph.is_hydrogen(a) && !graph.is_hydrogen(b);
      const bool is_known = apart[b] == 4 || (apart[b] > 4 && apart[b] < far && atoms <= 300);
      const double soft = std::max((apart[b] == 4 ? 0.9 : 1.0) * usual, 2.68);
      const bool is_own = is_soft && are_heavy && is_known && start >= std::max(usual, soft);
      pairs.push_back({a, b, is_own ? soft : std::min(usual, start)});
    }
  }
  return pairs;
}

TEST_P(SampleOverlapLaw, NoneIsDeeperThanReported) {
  const SampleTask* last = nullptr;
  std::vector<Pair> pairs;
  each_frame([&](const test::SampleCase& at, const SampleTask& task, const test::KeptFrame& frame) {
    if (!models()[at.model].has_sterics) return;
    if (&task != last || frame.frame == 0)
      pairs = pairs_of(test::model_of(at), !sampler().has_amplitude);
    last = &task;
    double worst = 0.0;
    for (const Pair& pair : pairs) {
      const double depth = pair.least - distance(frame.positions[pair.a], frame.positions[pair.b]);
      if (depth > kept)
        ADD_FAILURE() << task.framework().label(Bar{pair.a, pair.b}) << ": " << depth;
      worst = std::max(worst, depth);
    }
    EXPECT_NEAR(frame.max_overlap, worst, 1e-9);
  });
}

}  // namespace sample_overlap_law_test
}  // namespace pliant
