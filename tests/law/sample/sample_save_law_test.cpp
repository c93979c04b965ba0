// SPDX-License-Identifier: MIT
// Recorded frames are read back with the bits that they had, or as near as was asked for; and what
// goes on from a file gives the file of what never stopped.
#include <algorithm>
#include <cmath>

#include "law/sample/sample_cases.hpp"
#include "pliant/jobs/sample_checkpoint.hpp"
#include "support/temp_directory.hpp"
#include "unit/record/recorded_runs.hpp"

namespace pliant {
namespace sample_save_law_test {

using test::TempDirectory;

class SampleSaveLaw : public test::SampleLaw {};
PLIANT_FOR_ALL_SAMPLERS(SampleSaveLaw);

/// Records the first frames.
std::vector<test::KeptFrame> record(const std::filesystem::path& path, const SampleTask& task,
                                    std::size_t frames, const H5mdOptions& recording = {}) {
  H5mdHeader header;
  header.parameters = parameters_of(task.options());
  header.inputs = sample_inputs(task.start(), task.nodes());
  H5mdRecorder recorder(path, task.framework(), header, recording);
  std::vector<test::KeptFrame> kept;
  task.run([&](const Frame& frame) {
    recorder.record(frame);
    kept.push_back({frame.step, {frame.positions.begin(), frame.positions.end()}, {}});
    return kept.size() == frames;
  });
  recorder.close();
  return kept;
}

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
    EXPECT_EQ(worst_difference(path, record(path, *task, 5), itself), 0.0);
  });
}

TEST_P(SampleSaveLaw, ShorterNumbersAreTheNearest) {
  const auto itself = [](double x) { return x; };
  const auto nearest = [](double x) { return static_cast<double>(static_cast<float>(x)); };
  const test::SampleCase at = cases_of(GetParam()).back();
  const TempDirectory folder;
  const auto task = test::task_of(at, test::options_of(at));
  const auto single = folder / "single.h5md", rounded = folder / "rounded.h5md";
  EXPECT_EQ(worst_difference(single, record(single, *task, 3, {.single = true}), nearest), 0.0);
  const double worst =
      worst_difference(rounded, record(rounded, *task, 3, {.precision = 0.001}), itself);
  EXPECT_GT(worst, 0.0);
  EXPECT_LE(worst, 0.0005 + 1e-12);
}

TEST_P(SampleSaveLaw, WhatGoesOnIsWhatNeverStopped) {
  each_case([](const test::SampleCase& at) {
    const TempDirectory folder;
    const auto task = test::task_of(at, test::options_of(at));
    const auto whole = folder / "whole.h5md", part = folder / "part.h5md";
    record(whole, *task, 5);
    record(part, *task, 2);
    const H5mdCheckpoint from = read_checkpoint(part);
    add_frames(from, sample_options_from(from), {}, {});
    test::expect_same_file(whole, part);
  });
}

}  // namespace sample_save_law_test
}  // namespace pliant
