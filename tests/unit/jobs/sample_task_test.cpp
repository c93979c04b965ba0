// SPDX-License-Identifier: MIT
#include "pliant/jobs/sample_task.hpp"

#include "pliant/conformers/torsions/conformer_framework.hpp"
#include "pliant/jobs/conformers_task.hpp"
#include "pliant/sample/sample_fields.hpp"
#include "support/frameworks.hpp"
#include "support/test.hpp"
#include "unit/jobs/sampled_molecules.hpp"

namespace pliant::sample_task_test {

SampleAsked asked(const std::string& sampler, std::int64_t frames = 3) {
  SampleOptions options = unset_sample_options();
  options.frames = frames;
  options.sampler = sampler;
  return {options};
}

std::vector<Vec3> frames_of(const SampleTask& task) {
  std::vector<Vec3> all;
  task.run([&](const Frame& frame) {
    all.insert(all.end(), frame.positions.begin(), frame.positions.end());
    return false;
  });
  return all;
}

TEST(SampleTask, ChoosesTheSampler) {
  EXPECT_EQ(unset_sample_options().sampler, "auto");
  const MolecularModel peptide = test::model_of("cyclic_hexapeptide.pdb");
  const SampleTask modes(subject_of(peptide), asked("auto"));
  EXPECT_EQ(modes.options().sampler, "modes");
  EXPECT_EQ(modes.conformers(), nullptr);
  EXPECT_EQ(&modes.framework(), &peptide.framework);
  const MolecularModel butane = test::model_of("butane.sdf");
  const SampleTask torsions(subject_of(butane), asked("auto"));
  EXPECT_EQ(torsions.options().sampler, "torsions");
  EXPECT_EQ(&torsions.framework(), torsions.conformers());
}

/// Options of a molecule that counts so many residues.
SampleOptions chosen(std::size_t residues, const SampleAsked& given) {
  const MolecularModel peptide = test::model_of("cyclic_hexapeptide.pdb");
  SampleSubject subject = subject_of(peptide);
  subject.nodes.positions.resize(residues);
  return SampleTask(subject, given).options();
}

TEST(SampleTask, ProteinsAreReachedWithTwiceAsManyFrames) {
  SampleAsked open = asked("auto", open_frames);
  EXPECT_EQ(chosen(100, open).sampler, "modes");
  EXPECT_EQ(chosen(100, open).frames, 200);
  const SampleOptions far = chosen(101, open);
  EXPECT_EQ(far.sampler, "reach");
  EXPECT_EQ(far.frames, 400);
  EXPECT_EQ(far.near_frames, 200);
  EXPECT_EQ(chosen(101, asked("auto", 100)).sampler, "modes") << "all 100 are near";
  EXPECT_EQ(chosen(101, asked("auto", 101)).sampler, "reach");
}

// Pieces of an ensemble have frames of one kind, if they say so.
TEST(SampleTask, FramesThatAreAllNearAreThoseOfModes) {
  SampleAsked piece = asked("auto", 50);
  piece.options.first_frame = 150;
  EXPECT_ERROR(
      OptionError,
      "sampler reach: frames that begin at 150 are a piece of an ensemble; give each piece the "
      "same number of near frames",
      chosen(101, piece));
  piece.options.near_frames = 200;
  EXPECT_EQ(chosen(101, piece).sampler, "modes");
  piece.options.near_frames = 160;
  EXPECT_EQ(chosen(101, piece).sampler, "reach");
  std::string said;
  piece = asked("reach", 100);
  piece.options.log.function = [&](Severity, std::string_view text) { said = text; };
  EXPECT_EQ(chosen(101, piece).sampler, "modes");
  EXPECT_EQ(said,
            "sampler reach: all frames are those of sampler modes; it turns domains in those from "
            "number 100 on");
}

TEST(SampleTask, FramesAreThoseOfSample) {
  const MolecularModel butane = test::model_of("butane.sdf");
  const SampleTask task(subject_of(butane), asked("torsions"));
  const Framework framework = conformer_framework(butane.framework, butane.positions);
  std::vector<Vec3> expected;
  sample(framework, butane.positions, task.nodes(), task.options(), [&](const Frame& frame) {
    expected.insert(expected.end(), frame.positions.begin(), frame.positions.end());
    return false;
  });
  EXPECT_FALSE(expected.empty());
  EXPECT_TRUE(test::same_bits(frames_of(task), expected));
}

// The framework of conformers is in the file: it is not made from itself once more.
TEST(SampleTask, OneThatGoesOnTakesTheFrameworkAsItIs) {
  const MolecularModel butane = test::model_of("butane.sdf");
  const SampleTask task(subject_of(butane), asked("torsions"));
  const SampleTask again({task.framework(), task.start(), task.nodes()}, task.options());
  EXPECT_EQ(again.conformers(), nullptr);
  EXPECT_TRUE(test::same_bits(frames_of(again), frames_of(task)));
}

TEST(SampleTask, AnAmplitudeIsTakenWhereThereIsOne) {
  const MolecularModel peptide = test::model_of("cyclic_hexapeptide.pdb");
  SampleAsked far = asked("modes");
  far.amplitude = AmplitudeChoice{2.5, "2.5", "as given"};
  EXPECT_EQ(SampleTask(subject_of(peptide), far).options().amplitude, 2.5);
  far.options.sampler = "torsions";
  const auto refusal = [&] {
    return test::error_text<OptionError>([&] { SampleTask(subject_of(peptide), far); });
  };
  EXPECT_EQ(refusal(), "amplitude: sampler torsions has none: how far torsions turn is drawn");
  far.dashes = "--";
  EXPECT_EQ(refusal(), "--amplitude: sampler torsions has none: how far torsions turn is drawn");
}

TEST(SampleTask, OptionsAreHeldToTheirRanges) {
  const MolecularModel butane = test::model_of("butane.sdf");
  SampleAsked bad = asked("modes");
  bad.options.threads = 0;
  EXPECT_ERROR(OptionError, "threads = 0: must be from 1", SampleTask(subject_of(butane), bad));
  EXPECT_ERROR(OptionError, "frames = 0: must be a whole number from 1, such as frames=200",
               SampleTask(subject_of(butane), asked("modes", 0)));
}

TEST(SampleTask, ItEndsWhereItIsToldTo) {
  const MolecularModel peptide = test::model_of("cyclic_hexapeptide.pdb");
  const SampleTask task(subject_of(peptide), asked("modes", 50));
  const SampleSummary summary = task.run({}, [] { return true; });
  EXPECT_TRUE(summary.stopped_by_caller);
  EXPECT_LT(summary.frames, 50);
}

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

}  // namespace pliant::sample_task_test
