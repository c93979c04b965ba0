// SPDX-License-Identifier: MIT
// The table of faults: a run whose writes fail, or that dies, at every write there is. No frame
// that was committed is lost, and the run goes on from what is left as if nothing had happened.
//
// PLIANT_ALL: more frames, and large ones.
#include <cerrno>

#include "support/test.hpp"
#include "unit/record/recorded_runs.hpp"
#include "unit/record/samples.hpp"
#include "unit/record/write_calls.hpp"

namespace pliant::fault_test {

using namespace test;
namespace fs = std::filesystem;

struct FaultCase {
  const char* name;
  std::size_t joints;
  bool compress;
  std::int64_t steps;
  bool is_long;  ///< only with PLIANT_ALL

  friend void PrintTo(const FaultCase& that, std::ostream* out) { *out << that.name; }
};

class FaultTable : public ::testing::TestWithParam<FaultCase> {
 protected:
  void SetUp() override {
    if (GetParam().is_long && !looks_at_all()) GTEST_SKIP() << "only with PLIANT_ALL";
    options_.steps = GetParam().steps;
    options_.every = 2;
    options_.resolve.seed = 5;
    record_run(directory_ / "whole", framework_, start_, options_, recording_);
  }

  static bool looks_at_all() { return std::getenv("PLIANT_ALL") != nullptr; }

  static Framework straight_chain(std::size_t joints) {
    FrameworkParts parts{.joint_count = joints};
    for (Joint i = 0; i + 1 < joints; ++i) parts.bars.push_back({i, i + 1});
    parts.rest_lengths.assign(parts.bars.size(), 1.5);
    return Framework(std::move(parts));
  }
  static State straight(std::size_t joints) {
    std::vector<Vec3> positions;
    for (std::size_t i = 0; i < joints; ++i) positions.push_back({1.5 * double(i), 0, 0});
    return State(positions);
  }

  /// A run into run.h5md; `look` is shown the recorder after each frame.
  void record_all(const std::function<void(const H5mdRecorder&)>& look) {
    H5mdHeader header;
    header.parameters = parameters_of(options_, framework_);
    header.inputs = RunInputs();
    H5mdRecorder recorder(run_, framework_, header, recording_);
    State state = start_;
    run(framework_, state, options_, {[&](const Frame& frame) {
          recorder.record(frame);
          look(recorder);
          return false;
        }});
    recorder.end_run(state);
    recorder.close();
  }

  /// A run into run.h5md whose writes fail from the k-th on. False if all were done before.
  bool fail_from(long k, int error, bool half) {
    std::int64_t committed = 0;
    std::string message;
    {
      WriteWatch watch;
      watch.fail_at = k;
      watch.error = error;
      watch.half = half;
      message = error_text<FileError>([&] {
        record_all([&](const H5mdRecorder& recorder) { committed = recorder.committed_frames(); });
      });
    }
    EXPECT_FALSE(fs::exists(directory_ / ".run.h5md.partial"));
    if (message.empty()) return false;
    const std::string reason = run_.string() + ": cannot write: " + std::strerror(error);
    if (committed > 0) {
      EXPECT_EQ(message,
                reason + "; the file holds the first " + std::to_string(committed) + " frames");
    } else {
      EXPECT_THAT(message, testing::StartsWith(reason));
    }
    EXPECT_EQ(fs::exists(run_), committed > 0);
    if (committed > 0) EXPECT_NO_THROW(expect_whole_again(run_, committed));
    if (!HasFailure()) fs::remove(run_);
    return true;
  }

  /// What is left has the committed frames, and goes on to the whole.
  void expect_whole_again(const fs::path& left, std::int64_t committed) const {
    {
      const H5mdReader reader(left), whole(directory_ / "whole");
      ASSERT_GE(reader.frames(), std::max<std::int64_t>(committed, 1));
      for (std::int64_t f = 0; f < reader.frames(); ++f)
        ASSERT_TRUE(same_bits(reader.positions(f), whole.positions(f))) << "frame " << f;
    }
    go_on(left, options_.steps, recording_);
    expect_same_file(directory_ / "whole", left);
  }

  const TempDirectory directory_;
  const fs::path run_ = directory_ / "run.h5md";
  const Framework framework_ = straight_chain(GetParam().joints);
  const State start_ = straight(GetParam().joints);
  const H5mdOptions recording_{.precision = GetParam().compress ? 1e-9 : 0.0, .flush_seconds = 0.0};
  RunOptions options_;
};

/// The disk is full, or broken, from the k-th write on, which may write half.
TEST_P(FaultTable, FailedWrites) {
  for (const auto& [error, half] : {std::pair(ENOSPC, false), {EIO, true}}) {
    SCOPED_TRACE(std::strerror(error));
    long failures = 0;
    for (long k = half ? 1 : 0; fail_from(k, error, half); k += looks_at_all() ? 1 : 5) {
      ++failures;
      ASSERT_FALSE(HasFailure()) << "write " << k;
    }
    EXPECT_GT(failures, 20);
    fs::remove(run_);
  }
}

/// Dies before every write, and within every write at each page.
TEST_P(FaultTable, Deaths) {
  const fs::path left = directory_ / "left", copy = directory_ / "copy";
  WriteReplay replay(left);
  std::int64_t committed = 0;
  long deaths = 0;
  const auto look = [&] {
    if (committed == 0) return;  // the file has no name yet
    if (deaths++ % 4 != 0 && !looks_at_all()) return;
    fs::copy_file(left, copy, fs::copy_options::overwrite_existing);
    expect_whole_again(copy, committed);
  };
  std::vector<WriteCall> calls;
  std::vector<std::pair<std::size_t, std::int64_t>> acknowledged;  // calls before, frames
  {
    WriteWatch watch;
    watch.keep = true;
    record_all([&](const H5mdRecorder& recorder) {
      acknowledged.emplace_back(watch.calls.size(), recorder.committed_frames());
    });
    calls = std::move(watch.calls);
  }
  std::size_t next = 0;
  for (std::size_t k = 0; k < calls.size(); ++k) {
    SCOPED_TRACE("write " + std::to_string(k));
    for (; next < acknowledged.size() && acknowledged[next].first <= k; ++next)
      committed = acknowledged[next].second;
    replay.apply(calls[k], look);
    look();
    ASSERT_FALSE(HasFailure());
  }
  EXPECT_GT(deaths, 20);
}

INSTANTIATE_TEST_SUITE_P(Frames, FaultTable,
                         ::testing::Values(FaultCase{"small", 5, false, 5, false},
                                           FaultCase{"small_compressed", 5, true, 5, false},
                                           FaultCase{"middling", 200, false, 9, true},
                                           FaultCase{"middling_compressed", 200, true, 9, true},
                                           FaultCase{"chunk_a_frame", 1400, false, 9, true},
                                           FaultCase{"chunk_a_frame_compressed", 1400, true, 9,
                                                     true},
                                           FaultCase{"many_frames", 3, false, 140, true},
                                           FaultCase{"many_frames_compressed", 3, true, 140, true},
                                           FaultCase{"large", 20'000, false, 5, true},
                                           FaultCase{"large_compressed", 20'000, true, 5, true}),
                         [](const auto& fault) { return fault.param.name; });

}  // namespace pliant::fault_test
