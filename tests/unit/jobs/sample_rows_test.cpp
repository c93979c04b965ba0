// SPDX-License-Identifier: MIT
// Every row of the table of options, with every sampler: what is recorded goes on as if it had
// never stopped. A row that files forget fails here by itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "pliant/jobs/sample_checkpoint.hpp"
#include "pliant/jobs/sample_task.hpp"
#include "pliant/sample/samplers.hpp"
#include "support/frameworks.hpp"
#include "support/temp_directory.hpp"
#include "unit/jobs/sampled_molecules.hpp"
#include "unit/record/recorded_runs.hpp"

namespace pliant {
namespace sample_rows_test {

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
    if (field.users.file && field.name != "frames" && field.name != "turn_amides")
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
  auto& [frames, first_frame, amplitude, amplitude_from, seed, threads, network, sampler,
         near_frames, around, around_joints, contact_energy, ring_systems, turn_amides, should_stop,
         log] = options;
  const std::set<const void*> members{&frames,      &first_frame, &amplitude,      &amplitude_from,
                                      &seed,        &threads,     &network,        &sampler,
                                      &near_frames, &around,      &contact_energy, &turn_amides};
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

}  // namespace sample_rows_test
}  // namespace pliant
