// SPDX-License-Identifier: MIT
// Every row of the table of options, with every sampler: what is recorded goes on as if it had
// never stopped. A row that files forget fails here by itself.
#include "law/sample/sample_cases.hpp"
#include "pliant/jobs/sample_checkpoint.hpp"
#include "pliant/jobs/sample_task.hpp"
#include "pliant/record/h5md/h5md_reader.hpp"
#include "pliant/sample/samplers.hpp"
#include "support/frameworks.hpp"
#include "support/molecules.hpp"
#include "support/test.hpp"
#include "unit/jobs/sampled_molecules.hpp"
#include "unit/record/recorded_runs.hpp"

namespace pliant::sample_rows_test {

using test::record_sample;

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

/// The start of `sampler`, at the end of a block of frames where there are blocks.
SampleOptions options_of(const SamplerEntry& sampler) {
  SampleOptions options{
      .frames = 5, .first_frame = 97, .amplitude = 0.4, .sampler = std::string(sampler.name)};
  if (!sampler.near_sampler.empty()) options.near_frames = 99;
  return options;
}

/// A selection is refused by samplers that have no place to open, what it holds without a ligand.
bool goes_with(const SampleField& field, const SamplerEntry& sampler) {
  if (field.name == "hold") return false;
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
    record_sample(folder / "whole.h5md", task, std::size_t(options.frames));
    record_sample(folder / "part.h5md", task, 2);
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
    if (field.users.file && field.name != "frames" && field.name != "amides" &&
        field.name != "hold")
      idle.insert(field.name);
  const MolecularModel model = test::held_peptide();
  for (const SamplerEntry& sampler : samplers()) {
    if (!sampler.has_amplitude) continue;
    const SampleOptions options = options_of(sampler);
    const auto usual = test::frames_of(SampleTask(subject_of(model), SampleAsked{options}));
    for (const SampleField& field : sample_fields()) {
      if (!goes_with(field, sampler)) continue;
      SampleOptions changed = options;
      std::visit(Change{field}, field.place(changed));
      const auto made = test::frames_of(SampleTask(subject_of(model), SampleAsked{changed}));
      const bool is_same = std::ranges::equal(made, usual, [](const auto& a, const auto& b) {
        return test::same_bits(a.positions, b.positions);
      });
      if (!is_same) idle.erase(field.name);
    }
  }
  EXPECT_EQ(idle, std::set<std::string_view>());
}

/// A member more, and this does not compile: it needs a row, or a place among the last.
TEST(SampleRows, EveryOptionHasOne) {
  SampleOptions options;
  auto& [frames, first_frame, amplitude, amplitude_from, seed, threads, sampler, near_frames,
         around, around_joints, hold, contact_energy, ring_systems, amides, both_hands, should_stop,
         log] = options;
  const std::set<const void*> members{&frames, &first_frame, &amplitude,      &amplitude_from,
                                      &seed,   &threads,     &sampler,        &near_frames,
                                      &around, &amides,      &contact_energy, &hold};
  std::set<const void*> places;
  for (const SampleField& field : sample_fields()) places.insert(address_of(field.place(options)));
  EXPECT_EQ(places, members);
  EXPECT_TRUE(around_joints.empty());
  EXPECT_FALSE(both_hands);
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

/// A sample of 7 frames from number 96, recorded.
std::unique_ptr<SampleTask> recorded(const std::filesystem::path& path,
                                     const std::string& sampler) {
  static const MolecularModel model = test::held_peptide();
  auto task =
      std::make_unique<SampleTask>(subject_of(model), SampleAsked{{.frames = 7,
                                                                   .first_frame = 96,
                                                                   .amplitude = 0.3,
                                                                   .seed = ~std::uint64_t{0},
                                                                   .sampler = sampler,
                                                                   .contact_energy = 5.0}});
  record_sample(path, *task, 7);
  return task;
}

TEST(SampleCheckpoint, WhatIsRecordedIsReadBack) {
  const test::TempDirectory folder;
  const auto task = recorded(folder / "a.h5md", "dilute");
  const H5mdCheckpoint read = read_checkpoint(folder / "a.h5md", 20);
  EXPECT_TRUE(read.is_sample());
  EXPECT_EQ(read.done, 7);
  const NetworkNodes nodes = nodes_of(read.inputs);
  EXPECT_EQ(nodes.of_joint, task->nodes().of_joint);
  EXPECT_EQ(nodes.chain, task->nodes().chain);
  EXPECT_TRUE(test::same_bits(nodes.positions, task->nodes().positions));
  EXPECT_TRUE(test::same_bits(read.inputs.start, task->start()));
  const SampleOptions again = sample_options_from(read);
  EXPECT_EQ(again.first_frame, 102);
  EXPECT_EQ(again.frames, 96 + 20 - 102);
  EXPECT_EQ(again.seed, ~std::uint64_t{0});
  EXPECT_EQ(again.contact_energy, 5.0);
}

TEST(SampleCheckpoint, FramesOfOtherBitsAreNotAddedTo) {
  const test::TempDirectory folder;
  const auto path = folder / "a.h5md";
  recorded(path, "modes");
  H5mdCheckpoint read = read_checkpoint(path, 9);
  for (auto& [name, value] : read.parameters)
    if (name == "sample/seed") value = std::string("5");
  EXPECT_ERROR(
      FileError,
      path.string() +
          ": the frame of step 102 is not what the run gives now: it was written by another "
          "version of Pliant",
      add_frames(read, sample_options_from(read), {}, {}));
  EXPECT_EQ(H5mdReader(path).frames(), 7);
  for (auto& [name, value] : read.parameters)
    if (name == "sample/seed") value = std::string("-5");
  EXPECT_ERROR(
      InputError,
      path.string() + ": its sample cannot go on: /parameters/sample/seed has an invalid value",
      sample_options_from(read));
}

}  // namespace pliant::sample_rows_test
