// SPDX-License-Identifier: MIT
// Recorded frames are read back with the bits that they had, or as near as was asked for; what goes
// on from a file gives the file of what never stopped; and what no sampler takes is refused in so
// many words. Cases in CI are enough of all.
#include "law/sample/sample_cases.hpp"
#include "pliant/jobs/sample_checkpoint.hpp"
#include "pliant/molecule/bonds/bonds.hpp"
#include "support/frameworks.hpp"
#include "support/test.hpp"
#include "unit/record/recorded_runs.hpp"

namespace pliant::sample_save_law_test {

using test::TempDirectory;

class SampleSaveLaw : public test::SampleLaw {};
PLIANT_FOR_ALL_SAMPLERS(SampleSaveLaw);

/// The largest difference of a coordinate from what `expected` makes of it.
template <class Expected>
double worst_difference(const std::filesystem::path& path,
                        const std::vector<test::KeptFrame>& frames, Expected expected) {
  const H5mdReader reader(path);
  EXPECT_EQ(reader.frames(), static_cast<std::int64_t>(frames.size()));
  double worst = 0.0;
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const std::vector<Vec3> read = reader.positions(static_cast<std::int64_t>(k));
    EXPECT_EQ(reader.step(static_cast<std::int64_t>(k)), frames[k].frame);
    for (std::size_t j = 0; j < read.size(); ++j) {
      const Vec3 x = frames[k].positions[j];
      worst = std::max({worst, std::abs(read[j].x - expected(x.x)),
                        std::abs(read[j].y - expected(x.y)), std::abs(read[j].z - expected(x.z))});
    }
  }
  return worst;
}

TEST_P(SampleSaveLaw, FramesAreReadBackAsTheyWere) {
  const auto itself = [](double x) { return x; };
  each_case([&](const test::SampleCase& at) {
    const TempDirectory folder;
    const auto task = test::task_of(at, test::options_of(at));
    const auto path = folder / "double.h5md";
    EXPECT_EQ(worst_difference(path, test::record_sample(path, *task, 5), itself), 0.0);
  });
}

TEST_P(SampleSaveLaw, RoundedNumbersAreTheNearest) {
  const auto itself = [](double x) { return x; };
  const test::SampleCase at = cases_of(GetParam()).back();
  const TempDirectory folder;
  const auto task = test::task_of(at, test::options_of(at));
  const auto rounded = folder / "rounded.h5md";
  const double worst = worst_difference(
      rounded, test::record_sample(rounded, *task, 3, {.precision = 0.001}), itself);
  EXPECT_GT(worst, 0.0);
  EXPECT_LE(worst, 0.0005 + 1e-12);
}

TEST_P(SampleSaveLaw, WhatGoesOnIsWhatNeverStopped) {
  each_case([](const test::SampleCase& at) {
    const TempDirectory folder;
    const auto task = test::task_of(at, test::options_of(at));
    const auto whole = folder / "whole.h5md", part = folder / "part.h5md";
    test::record_sample(whole, *task, 5);
    test::record_sample(part, *task, 2);
    const H5mdCheckpoint from = read_checkpoint(part);
    add_frames(from, sample_options_from(from), {}, {});
    test::expect_same_file(whole, part);
  });
}

TEST(SampleCases, AnyTwoRowsOfDifferentTablesMeet) {
  const auto pairs_of = [](const std::vector<test::SampleCase>& cases) {
    std::set<std::array<std::size_t, 3>> pairs;
    for (const auto& [sampler, model, molecule] : cases)
      pairs.insert({{0, sampler, model}, {1, sampler, molecule}, {2, model, molecule}});
    return pairs;
  };
  EXPECT_EQ(test::sampled_molecules().size(), 12U);
  const auto chosen = test::covering_sample_cases(), all = test::all_sample_cases();
  EXPECT_EQ(pairs_of(chosen), pairs_of(all));
  EXPECT_LT(chosen.size(), all.size() / 3);
}

class SampleRefusalLaw : public test::SampleLaw {
 protected:
  static std::string refusal_of(const SampleSubject& subject) {
    SampleOptions options{.frames = 1, .sampler = std::string(sampler().name)};
    const SampleTask task(subject, SampleAsked{options});
    return test::error_text<OptionError>([&] { task.run({}); });
  }
};
PLIANT_FOR_ALL_SAMPLERS(SampleRefusalLaw);

TEST_P(SampleRefusalLaw, PinnedAtomsAreRefused) {
  const char* expected = "sample: the framework has pinned joints, or lies in a plane";
  each_case([&](const test::SampleCase& at) {
    const MolecularModel& model = test::model_of(at);
    SampleSubject subject = subject_of(model);
    const Joint first = 0;
    const Framework pinned = model.framework.with_pinned({&first, 1});
    EXPECT_EQ(refusal_of({pinned, subject.start, subject.nodes}), expected);
  });
}

/// A single residue is one node, whatever its atoms do.
TEST_P(SampleRefusalLaw, OneNodeIsRefused) {
  Structure methane;
  methane.atoms.residues.push_back({"UNK", 1, ' ', ""});
  const Vec3 places[] = {{0, 0, 0}, {1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  for (std::size_t k = 0; k < std::size(places); ++k) {
    methane.atoms.names.emplace_back(k == 0 ? "C" : "H");
    methane.atoms.elements.push_back(k == 0 ? 6 : 1);
    methane.atoms.residue_of.push_back(0);
    methane.atoms.serials.push_back(static_cast<std::int64_t>(k) + 1);
    methane.positions.push_back(0.63 * places[k]);
  }
  perceive_bonds(methane);
  for (const ModelEntry& model : models()) {
    const MolecularModel made = build_model(methane, {.kind = model.kind});
    EXPECT_EQ(refusal_of(subject_of(made)), "network: 1 node; it needs 2 or more") << model.name;
  }
}

TEST_P(SampleRefusalLaw, AnAmplitudeIsRefusedWhereThereIsNone) {
  each_case([](const test::SampleCase& at) {
    SampleAsked asked{test::options_of(at)};
    asked.amplitude = AmplitudeChoice{1.0, "1", "as given"};
    const std::string found =
        test::error_text<OptionError>([&] { SampleTask(subject_of(test::model_of(at)), asked); });
    EXPECT_EQ(found, sampler().has_amplitude ? ""
                                             : "amplitude: sampler " + std::string(sampler().name) +
                                                   " has none: how far torsions turn is drawn");
  });
}

}  // namespace pliant::sample_save_law_test
