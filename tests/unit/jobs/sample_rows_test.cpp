// SPDX-License-Identifier: MIT
// Every row of the table of options, with every sampler: what is recorded goes on as if it had
// never stopped. A row that files forget fails here by itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "pliant/jobs/sample_checkpoint.hpp"
#include "pliant/jobs/sample_task.hpp"
#include "pliant/record/h5md/h5md_reader.hpp"
#include "pliant/sample/samplers.hpp"
#include "support/error_text.hpp"
#include "support/frameworks.hpp"
#include "support/molecules.hpp"
#include "support/temp_directory.hpp"
#include "unit/jobs/sampled_molecules.hpp"
#include "unit/record/recorded_runs.hpp"
#include "unit/record/samples.hpp"

namespace pliant::sample_rows_test {

using test::Peptide;

const void* address_of(OptionPlace place) {
  return std::visit([](auto* at) -> const void* { return at; }, place);
}

/// Puts another value than the one that is there into a place.
struct Change {
  const SampleField& field;

  void operator()(bool* value) const { *value = !*value; }
  void operator()(std::int64_t* value) const { ++*value; }
  void operator()(std::uint64_t* value) const { *value = ~*value; }
  void operator()(double* value) const { *value *= 0.5; }
  void operator()(OptionNames* value) const { value->push_back("GOL"); }
  void operator()(OptionGroups*) const {}
  void operator()(std::string* value) const {
    if (field.choices == nullptr) return void(*value = "resid 1-2");
    const auto known = field.choices();
    *value = *std::ranges::find_if(known, [&](std::string_view name) { return name != *value; });
  }
};

struct Recorded {
  std::vector<Vec3> positions;  ///< of all frames
};

/// Records a sample, or its first frames.
Recorded record(const std::filesystem::path& path, const SampleTask& task, std::int64_t frames) {
  H5mdHeader header;
  header.parameters = parameters_of(task.options());
  header.inputs = sample_inputs(task.start(), task.nodes());
  H5mdRecorder recorder(path, task.framework(), header);
  Recorded made;
  std::int64_t seen = 0;
  task.run([&](const Frame& frame) {
    recorder.record(frame);
    made.positions.insert(made.positions.end(), frame.positions.begin(), frame.positions.end());
    return ++seen == frames;
  });
  recorder.close();
  return made;
}

/// The start of `sampler`, at the end of a block of frames where there are blocks.
SampleOptions options_of(const SamplerEntry& sampler) {
  SampleOptions options;
  options.frames = 5;
  options.first_frame = 97;
  options.amplitude = 0.4;
  options.sampler = std::string(sampler.name);
  if (!sampler.near_sampler.empty()) options.near_frames = 99;
  return options;
}

/// A selection is refused by samplers that have no place to open.
bool goes_with(const SampleField& field, const SamplerEntry& sampler) {
  return field.name != "around" || sampler.has_place;
}

class SampleRows : public testing::TestWithParam<std::size_t> {};
INSTANTIATE_TEST_SUITE_P(Samplers, SampleRows, testing::Range<std::size_t>(0, samplers().size()),
                         [](const auto& at) { return std::string(samplers()[at.param].name); });

TEST_P(SampleRows, EachGoesOnAsIfItHadNeverStopped) {
  const SamplerEntry& sampler = samplers()[GetParam()];
  const MolecularModel model =
      sampler.has_amplitude ? test::held_peptide() : test::model_of("butane.sdf");
  for (const SampleField& field : sample_fields()) {
    SCOPED_TRACE(field.name);
    if (!goes_with(field, sampler)) continue;
    const test::TempDirectory folder;
    SampleOptions options = options_of(sampler);
    std::visit(Change{field}, field.place(options));
    const SampleTask task(subject_of(model), SampleAsked{options});
    record(folder / "whole.h5md", task, options.frames);
    record(folder / "part.h5md", task, 2);
    const H5mdCheckpoint from = read_checkpoint(folder / "part.h5md");
    const auto summary =
        add_frames(from, sample_options_from(from), {}, [](const Frame&) { return false; });
    EXPECT_EQ(summary.frames, options.frames - 2);
    test::expect_same_file(folder / "whole.h5md", folder / "part.h5md");
  }
}

/// Rows of which nothing depends would pass above whatever files hold.
TEST(SampleRows, WhatFilesHoldChangesFramesOfSomeSampler) {
  std::set<std::string_view> idle;
  for (const SampleField& field : sample_fields())
    if (field.users.file && field.name != "frames" && field.name != "amides")
      idle.insert(field.name);
  const MolecularModel model = test::held_peptide();
  const test::TempDirectory folder;
  for (const SamplerEntry& sampler : samplers()) {
    if (!sampler.has_amplitude) continue;
    const SampleOptions options = options_of(sampler);
    const auto usual = record(folder / (options.sampler + ".h5md"),
                              SampleTask(subject_of(model), SampleAsked{options}), 5);
    for (const SampleField& field : sample_fields()) {
      if (!goes_with(field, sampler)) continue;
      SampleOptions changed = options;
      std::visit(Change{field}, field.place(changed));
      const std::string number = std::to_string(&field - sample_fields().data());
      const std::string name = options.sampler + "-" + number + ".h5md";
      const auto made =
          record(folder / name, SampleTask(subject_of(model), SampleAsked{changed}), 5);
      if (!test::same_bits(made.positions, usual.positions)) idle.erase(field.name);
    }
  }
  EXPECT_EQ(idle, std::set<std::string_view>());
}

/// A member more, and this does not compile: it needs a row, or a place among the last.
TEST(SampleRows, EveryOptionHasOne) {
  SampleOptions options;
  auto& [frames, first_frame, amplitude, amplitude_from, seed, threads, sampler, near_frames,
         around, around_joints, contact_energy, ring_systems, amides, should_stop, log] = options;
  const std::set<const void*> members{&frames, &first_frame, &amplitude,     &amplitude_from,
                                      &seed,   &threads,     &sampler,       &near_frames,
                                      &around, &amides,      &contact_energy};
  std::set<const void*> places;
  for (const SampleField& field : sample_fields()) places.insert(address_of(field.place(options)));
  EXPECT_EQ(places, members);
  EXPECT_TRUE(around_joints.empty());
  EXPECT_FALSE(should_stop);
  EXPECT_FALSE(log.function);
}

TEST(SampleRows, EachSaysWhatItIs) {
  SampleOptions options;
  std::set<std::string_view> names;
  for (const SampleField& field : sample_fields()) {
    SCOPED_TRACE(field.name);
    const OptionPlace place = field.place(options);
    // An amplitude is asked for, and found: two rows, recorded apart.
    EXPECT_TRUE(names.insert(field.recorded.empty() ? field.name : field.recorded).second);
    EXPECT_FALSE(field.summary.empty());
    EXPECT_EQ(field.choices != nullptr || field.kind.ends_with("SELECTION") ||
                  field.kind.ends_with("FILE"),
              std::holds_alternative<std::string*>(place));
    const bool is_share = field.range == Range::zero_to_one;
    EXPECT_EQ(field.unit.empty(), !std::holds_alternative<double*>(place) || is_share);
  }
}

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

}  // namespace pliant::sample_rows_test
