// SPDX-License-Identifier: MIT
// Every row of samplers() with every network and every model on twelve molecules: what laws of
// samples iterate over. CI takes some cases of these, among which any two rows of different tables
// meet; PLIANT_ALL takes all.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pliant/jobs/sample_task.hpp"
#include "pliant/model/model.hpp"
#include "pliant/record/h5md/h5md_recorder.hpp"
#include "pliant/sample/samplers.hpp"

namespace pliant::test {

/// A molecule that is sampled, and why it is here.
struct SampledMolecule {
  std::string_view name, reason;
  Structure (*make)();  ///< its bonds are known
};

std::span<const SampledMolecule> sampled_molecules();

/// Numbers of rows: of samplers(), models(), sampled_molecules().
struct SampleCase {
  std::size_t sampler = 0, model = 0, molecule = 0;
  std::string name() const;
};

/// All cases, in the order of the tables.
std::vector<SampleCase> all_sample_cases();
/// As few as a greedy choice finds, so that any two rows of different tables are in one of them.
std::vector<SampleCase> covering_sample_cases();

/// The model of a case; made once a process.
const MolecularModel& model_of(const SampleCase& at);

/// A frame, and what was said of it.
struct KeptFrame {
  std::int64_t frame = 0;
  std::vector<Vec3> positions;
  std::vector<std::uint8_t> limits_off;
  double max_residual = 0.0, max_limit = 0.0, max_overlap = 0.0;
};

/// Whether draws may be given up: conformers of what contacts hold.
bool may_fail(const SampleCase& at);

/// A few frames, from a seed.
SampleOptions options_of(const SampleCase& at);
std::unique_ptr<SampleTask> task_of(const SampleCase& at, const SampleOptions& options);
/// Fails where frames that were given up are not reported.
std::vector<KeptFrame> frames_of(const SampleTask& task);
std::vector<KeptFrame> frames_of(const SampleCase& at, const SampleOptions& options);

/// Records the first frames of a sample.
std::vector<KeptFrame> record_sample(const std::filesystem::path& path, const SampleTask& task,
                                     std::size_t frames, const H5mdOptions& recording = {});

/// Numbers, positions and limits that are off are the same bit by bit.
void expect_same_frames(const std::vector<KeptFrame>& one, const std::vector<KeptFrame>& other);

/// A suite that runs once for each row of the table of samplers.
class SampleLaw : public testing::TestWithParam<std::size_t> {
 protected:
  static const SamplerEntry& sampler() { return samplers()[GetParam()]; }

  /// Calls `look(case)` for each case of this sampler.
  template <class Look>
  static void each_case(Look look) {
    for (const SampleCase& at : cases_of(GetParam())) {
      SCOPED_TRACE(at.name());
      look(at);
    }
  }

  /// Calls `look(case, task, frame)` for each frame of each case.
  template <class Look>
  static void each_frame(Look look) {
    each_case([&](const SampleCase& at) {
      const auto task = task_of(at, options_of(at));
      const std::vector<KeptFrame> frames = frames_of(*task);
      const auto asked = static_cast<std::size_t>(task->options().frames);
      EXPECT_TRUE(frames.size() == asked || may_fail(at));
      EXPECT_FALSE(frames.empty());
      for (const KeptFrame& frame : frames) {
        SCOPED_TRACE("frame " + std::to_string(frame.frame));
        look(at, *task, frame);
      }
    });
  }

  /// Those of all where PLIANT_ALL is set.
  static std::vector<SampleCase> cases_of(std::size_t sampler);
};

inline std::string sampler_name(const testing::TestParamInfo<std::size_t>& row) {
  return std::string(samplers()[row.param].name);
}

}  // namespace pliant::test

#define PLIANT_FOR_ALL_SAMPLERS(suite)                                                  \
  INSTANTIATE_TEST_SUITE_P(Table, suite,                                                \
                           testing::Range<std::size_t>(0, ::pliant::samplers().size()), \
                           ::pliant::test::sampler_name)
