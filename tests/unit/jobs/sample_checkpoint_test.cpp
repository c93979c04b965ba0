// SPDX-License-Identifier: MIT
#include "pliant/jobs/sample_checkpoint.hpp"

#include <gtest/gtest.h>

#include "pliant/record/h5md/h5md_reader.hpp"
#include "support/error_text.hpp"
#include "support/frameworks.hpp"
#include "support/molecules.hpp"
#include "unit/record/recorded_runs.hpp"
#include "unit/record/samples.hpp"

namespace pliant {
namespace sample_checkpoint_test {

using test::Peptide;

/// Two far atoms of it are held near each other.
Peptide held_peptide() {
  Peptide made = test::peptide();
  FrameworkParts parts = made.framework.parts();
  const double apart = distance(made.start[0], made.start[30]);
  parts.limits = {{.a = 0, .b = 30, .most = apart + 0.5, .energy = -4.0, .group = 0}};
  made.framework = Framework(std::move(parts));
  return made;
}

SampleOptions options_for(const std::string& sampler) {
  SampleOptions options;
  options.frames = 7;
  options.first_frame = 96;
  options.amplitude = 0.3;
  options.seed = ~std::uint64_t{0};
  options.sampler = sampler;
  options.contact_energy = 5.0;
  return options;
}

void record_sample(const std::filesystem::path& path, const Peptide& from,
                   const SampleOptions& options, std::int64_t planned) {
  H5mdHeader header;
  SampleOptions whole = options;
  whole.frames = planned;
  header.parameters = parameters_of(whole);
  header.inputs = sample_inputs(from.start, from.nodes);
  H5mdRecorder recorder(path, from.framework, header);
  sample(from.framework, from.start, from.nodes, options, [&](const Frame& frame) {
    recorder.record(frame);
    return false;
  });
  recorder.close();
}

class SampleCheckpoint : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Samplers, SampleCheckpoint, testing::Values("modes", "dilute"));

TEST_P(SampleCheckpoint, GoesOnAsIfItHadNeverStopped) {
  const test::TempDirectory folder;
  const Peptide from = held_peptide();
  SampleOptions options = options_for(GetParam());
  record_sample(folder / "whole.h5md", from, options, 7);
  options.frames = 3;
  record_sample(folder / "part.h5md", from, options, 7);
  const H5mdCheckpoint checkpoint = read_checkpoint(folder / "part.h5md");
  EXPECT_TRUE(checkpoint.is_sample());
  EXPECT_EQ(checkpoint.done, 3);
  std::int64_t seen = options.first_frame + 3;
  const SampleSummary summary =
      add_frames(checkpoint, sample_options_from(checkpoint), {}, [&](const Frame& frame) {
        EXPECT_EQ(frame.step, seen++);
        return false;
      });
  EXPECT_EQ(summary.frames, 4);
  test::expect_same_file(folder / "whole.h5md", folder / "part.h5md");
}

TEST(SampleCheckpoint, WhatIsRecordedIsReadBack) {
  const test::TempDirectory folder;
  const Peptide from = held_peptide();
  const SampleOptions options = options_for("dilute");
  record_sample(folder / "a.h5md", from, options, 7);
  const H5mdCheckpoint read = read_checkpoint(folder / "a.h5md", 20);
  const NetworkNodes nodes = nodes_of(read.inputs);
  EXPECT_EQ(nodes.of_joint, from.nodes.of_joint);
  EXPECT_EQ(nodes.chain, from.nodes.chain);
  EXPECT_TRUE(test::same_bits(nodes.positions, from.nodes.positions));
  EXPECT_TRUE(test::same_bits(read.inputs.start, from.start));
  const SampleOptions again = sample_options_from(read);
  EXPECT_EQ(again.first_frame, 102);
  EXPECT_EQ(again.frames, 96 + 20 - 102);
  EXPECT_EQ(again.seed, options.seed);
  EXPECT_EQ(again.contact_energy, options.contact_energy);
}

TEST(SampleCheckpoint, FramesOfOtherBitsAreNotAddedTo) {
  const test::TempDirectory folder;
  const Peptide from = held_peptide();
  record_sample(folder / "a.h5md", from, options_for("modes"), 7);
  H5mdCheckpoint read = read_checkpoint(folder / "a.h5md", 9);
  for (auto& [path, value] : read.parameters)
    if (path == "sample/seed") value = std::string("5");
  EXPECT_EQ(test::error_text<FileError>([&] {
              add_frames(read, sample_options_from(read), {}, [](const Frame&) { return false; });
            }),
            (folder / "a.h5md").string() +
                ": the frame of step 102 is not what the run gives now: it was written by another "
                "version of Pliant");
  EXPECT_EQ(H5mdReader(folder / "a.h5md").frames(), 7);
}

TEST(SampleCheckpoint, ParametersThatAreNoneAreTold) {
  H5mdCheckpoint from;
  from.path = "a.h5md";
  from.last_step = 3;
  from.steps = 9;
  from.parameters = parameters_of(options_for("modes"));
  const auto fault = [&] {
    return test::error_text<InputError>([&] { sample_options_from(from); });
  };
  EXPECT_EQ(sample_options_from(from).frames, 6);
  for (auto& [path, value] : from.parameters)
    if (path == "sample/seed") value = std::string("-5");
  EXPECT_EQ(fault(),
            "a.h5md: its sample cannot go on: /parameters/sample/seed has an invalid value");
  for (auto& [path, value] : from.parameters)
    if (path == "sample/amplitude") value = std::string("far");
  EXPECT_EQ(fault(),
            "a.h5md: its sample cannot go on: /parameters/sample/amplitude has an invalid value");
  from.parameters.clear();
  EXPECT_EQ(fault(), "a.h5md: its sample cannot go on: does not say /parameters/sample/frames");
}

}  // namespace sample_checkpoint_test
}  // namespace pliant
