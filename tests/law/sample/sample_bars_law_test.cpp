// SPDX-License-Identifier: MIT
// Every bar of every frame is whole, and so is every bond and, where angles are held, every angle
// of the structure, whatever the framework says.
#include <algorithm>
#include <cmath>

#include "law/sample/sample_cases.hpp"
#include "pliant/model/atoms/atom_graph.hpp"
#include "support/frameworks.hpp"

namespace pliant {
namespace sample_bars_law_test {

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

}  // namespace sample_bars_law_test
}  // namespace pliant
