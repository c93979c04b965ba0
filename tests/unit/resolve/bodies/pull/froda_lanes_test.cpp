// SPDX-License-Identifier: MIT
#include "pliant/resolve/bodies/pull/froda_lanes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "pliant/framework/measures/neighbour_list.hpp"
#include "pliant/resolve/bodies/pull/froda_solver.hpp"
#include "support/frameworks.hpp"
#include "support/molecules.hpp"

namespace pliant {
namespace froda_lanes_test {

struct Molecule {
  Framework framework;
  std::vector<Vec3> start;
};

/// Spheres that are `least` apart (Angstrom), a limit between the first atom and the last where
/// these have no bar, and torsion preferences about every third bond that can turn.
Molecule molecule(const std::string& file, double least) {
  const Structure structure = test::bonded(molecule_file(file));
  BuildOptions options{.bars = BarKind::angles};
  const Framework bare = build_framework(structure, options);
  auto sterics =
      std::make_shared<Sterics>(Sterics{.kind_count = 1,
                                        .kinds = std::vector<std::uint16_t>(bare.joint_count(), 0),
                                        .least = {least},
                                        .excluded_bonds = 3});
  options.sterics = sterics;
  sterics->own = own_distances(build_framework(structure, options), structure.positions);
  const auto last = static_cast<Joint>(bare.joint_count() - 1);
  const double apart = distance(structure.positions.front(), structure.positions.back());
  const bool is_barred = std::any_of(bare.bars().begin(), bare.bars().end(), [&](Bar bar) {
    return std::min(bar.a, bar.b) == 0 && std::max(bar.a, bar.b) == last;
  });
  if (!is_barred)
    options.limits = {{0, last, 0.0, apart + 0.5, LimitKind::given, 0.0, no_limit_group}};
  auto wanted = std::make_shared<TorsionPreferences>();
  for (Joint k = 0; k + 4 < bare.joint_count(); k += 3)
    wanted->staggered.push_back({{k, k + 1, k + 2, k + 3}, 0.1});
  options.torsion_preferences = wanted;
  return {build_framework(structure, options), structure.positions};
}

FrodaOptions careful() {
  FrodaOptions options;
  options.is_careful = true;
  options.has_torsion_preferences = true;
  return options;
}

/// Three of a molecule, side by side.
Molecule three_of(const Molecule& one) {
  const std::size_t joints = one.start.size();
  FrameworkParts all;
  all.joint_count = 3 * joints;
  auto sterics = std::make_shared<Sterics>(*one.framework.sterics());
  sterics->own.clear();
  sterics->kinds.assign(3 * joints, 0);
  std::vector<Vec3> start;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto first = static_cast<Joint>(k * joints);
    for (const Bar bar : one.framework.bars()) all.bars.push_back({first + bar.a, first + bar.b});
    for (const double rest : one.framework.rest_lengths()) all.rest_lengths.push_back(rest);
    for (const Vec3 x : one.start) start.push_back(x + Vec3{0, 0, 7.0 * double(k)});
  }
  all.drawn = start;
  all.sterics = sterics;
  sterics->own = own_distances(Framework(all), start);
  return {Framework(std::move(all)), start};
}

/// What each of some frames is asked for: some wait for several targets on the way. The third is
/// asked for nothing, and every fourth without the limit.
struct Frames {
  std::vector<std::vector<Vec3>> targets, out;
  std::vector<std::uint8_t> off{1};

  Frames(const Molecule& m, std::size_t count) : out(count, m.start) {
    for (std::size_t k = 0; k < count; ++k)
      targets.push_back(test::shake(m.framework, m.start, k == 2 ? 0.0 : 0.8 * double(k % 7), k));
  }
  LimitsOff limits_off(std::size_t k) const {
    return k % 4 == 3 && has_limit ? LimitsOff(off) : LimitsOff();
  }
  bool has_limit = true;
};

void expect_those_of_a_solver(const Molecule& m, const LaneKernels& kernels, std::size_t count) {
  const auto plan = BodyPlan::make(m.framework);
  ASSERT_TRUE(plan && FrodaLanes::can_take(*plan));
  Frames frames(m, count);
  frames.has_limit = !m.framework.limits().empty();
  std::vector<FrodaJob> jobs;
  FrodaLanes lanes(m.framework, *plan, kernels);
  for (int again = 0; again < 2; ++again) {  // nothing is left over from the first time
    jobs.clear();
    for (std::size_t k = 0; k < count; ++k)
      jobs.push_back({{m.start, frames.targets[k], frames.limits_off(k)}, frames.out[k]});
    lanes.resolve(jobs, careful());
  }
  FrodaSolver solver(m.framework, *plan);
  std::vector<Vec3> alone = m.start;
  for (std::size_t k = 0; k < count; ++k) {
    const FrodaResult result =
        solver.resolve(m.start, frames.targets[k], alone, careful(), frames.limits_off(k));
    EXPECT_EQ(frames.out[k], alone) << k << " of " << count;
    EXPECT_EQ(jobs[k].result.is_whole, result.is_whole) << k;
    EXPECT_EQ(jobs[k].result.steps, result.steps) << k;
    EXPECT_EQ(jobs[k].result.max_overlap, result.max_overlap) << k;
    EXPECT_EQ(jobs[k].result.max_limit, result.max_limit) << k;
  }
}

/// To the last bit, on all levels, however many stand side by side.
TEST(FrodaLanes, FramesAreBitForBitThoseOfASolver) {
  for (const LaneKernels* kernels : lane_levels())
    for (const char* file : {"peptide_20.pdb", "cholesterol.cif", "butane.sdf"})
      for (const double least : {1.3, 2.2})  // some frames have no contacts, or all have
        for (const std::size_t count : {1, 2, 3, 8, 21}) {
          SCOPED_TRACE(std::string(kernels->level) + " " + file + " " + std::to_string(least));
          expect_those_of_a_solver(molecule(file, least), *kernels, count);
        }
}

/// Several molecules, and one that cannot turn at all.
TEST(FrodaLanes, TakeManyTreesAndNoTurns) {
  for (const LaneKernels* kernels : lane_levels()) {
    SCOPED_TRACE(kernels->level);
    expect_those_of_a_solver(three_of(molecule("butane.sdf", 2.2)), *kernels, 9);
    expect_those_of_a_solver(molecule("benzene.sdf", 1.3), *kernels, 9);
    expect_those_of_a_solver(three_of(molecule("benzene.sdf", 2.2)), *kernels, 9);
  }
}

TEST(FrodaLanes, TakeNoCutLoops) {
  const Molecule ring = molecule("crown_18_6.cif", 1.3);
  EXPECT_FALSE(FrodaLanes::can_take(*BodyPlan::make(ring.framework)));
}

}  // namespace froda_lanes_test
}  // namespace pliant
