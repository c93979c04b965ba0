// SPDX-License-Identifier: MIT
// Starts of conformers, and conformers that are exact in the bars of their own start.
#include "pliant/jobs/conformers_task.hpp"

#include <gtest/gtest.h>

#include "pliant/base/error.hpp"
#include "pliant/conformers/torsions/conformer_framework.hpp"
#include "pliant/jobs/sample_task.hpp"
#include "support/frameworks.hpp"
#include "unit/jobs/sampled_molecules.hpp"

namespace pliant {
namespace conformers_task_test {

TEST(ConformersTask, EachConformerHasTheBarsOfItsOwnStart) {
  const Structure glucose = test::bonded(molecule_file("glucose.cif"));
  const ConformerOptions asked{.frames = 40, .starts = 4, .seed = 3};
  const auto starts = conformer_starts(glucose, asked);
  ASSERT_GT(starts.size(), 1U);
  const DrawnConformers drawn = draw_conformers(starts, asked);
  ASSERT_EQ(drawn.positions.size(), 40U);
  EXPECT_LT(drawn.max_residual, 1e-12);
  for (std::size_t k = 0; k < drawn.positions.size(); ++k) {
    const MolecularModel& start = starts[drawn.start[k]];
    const Framework framework = conformer_framework(start.framework, start.positions);
    EXPECT_LT(test::worst_bar(framework, drawn.positions[k]), 1e-12);
  }
  EXPECT_GT(test::worst_bar(starts[0].framework, starts[1].positions), 1e-4);  // other lengths
}

TEST(ConformersTask, OfOneStartTheyAreThoseOfASample) {
  const Structure aspirin = test::bonded(molecule_file("aspirin.sdf"));
  const ConformerOptions asked{.frames = 10, .starts = 1};
  const auto starts = conformer_starts(aspirin, asked);
  const DrawnConformers drawn = draw_conformers(starts, asked);
  SampleAsked wanted;
  wanted.options.sampler = "torsions";
  wanted.options.frames = 10;
  const SampleTask task(subject_of(starts[0]), wanted);
  std::size_t k = 0;
  task.run([&](const Frame& frame) {
    EXPECT_TRUE(test::same_bits(frame.positions, drawn.positions[k++]));
    return false;
  });
  EXPECT_EQ(k, 10U);
}

TEST(ConformersTask, ThreadsChangeNothing) {
  const Structure butane = test::bonded(molecule_file("butane.sdf"));
  ConformerOptions asked{.frames = 30, .starts = 3};
  const DrawnConformers one = draw_conformers(conformer_starts(butane, asked), asked);
  asked.threads = 3;
  const DrawnConformers three = draw_conformers(conformer_starts(butane, asked), asked);
  ASSERT_EQ(one.positions.size(), three.positions.size());
  for (std::size_t k = 0; k < one.positions.size(); ++k)
    EXPECT_TRUE(test::same_bits(one.positions[k], three.positions[k]));
  EXPECT_EQ(one.energies, three.energies);
}

TEST(ConformersTask, NeedsAStart) {
  const Structure butane = test::bonded(molecule_file("butane.sdf"));
  EXPECT_THROW(conformer_starts(butane, {.starts = 0}), OptionError);
}

}  // namespace conformers_task_test
}  // namespace pliant
