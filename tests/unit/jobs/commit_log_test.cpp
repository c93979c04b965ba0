// SPDX-License-Identifier: MIT
#include "pliant/jobs/files/commit_log.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "pliant/base/error.hpp"
#include "support/temp_directory.hpp"

namespace pliant {
namespace commit_log_test {

namespace fs = std::filesystem;

class CommitLogs : public testing::Test {
 protected:
  static constexpr std::uint64_t key = 17;

  Frame frame_of(std::int64_t step) {
    shown_ = {{double(step), 0, -0.0}, {1, 2, 3}};
    Frame frame;
    frame.step = step;
    frame.time = 0.5 * double(step);
    frame.positions = shown_;
    frame.limits_off = limits_off_;
    frame.force = {1, 2, 3};
    frame.stop = Stop::max_sweeps;
    frame.drawn_by = DrawnBy::turns;
    return frame;
  }

  State state_of(std::int64_t step) const {
    State state({{4, 5, 6}});
    state.previous = {{7, 8, double(step)}};
    state.step = step;
    state.limits_off = limits_off_;
    return state;
  }

  KeptFrames frames(std::int64_t count) {
    KeptFrames kept;
    for (std::int64_t step = 0; step < count; ++step) kept.add(frame_of(step));
    return kept;
  }

  std::vector<std::int64_t> steps_in(const CommitLog& log, std::int64_t walker) const {
    std::vector<std::int64_t> steps;
    log.replay(walker, [&](const Frame& frame) { steps.push_back(frame.step); });
    return steps;
  }

  const test::TempDirectory folder_;
  const fs::path path_ = folder_ / "c.log";
  const std::vector<std::uint8_t> limits_off_{1, 0, 1, 1, 0, 0, 0, 0, 1};
  std::vector<Vec3> shown_;
};

TEST_F(CommitLogs, GiveBackWhatWasCommitted) {
  const KeptFrames kept = frames(3);
  {
    CommitLog log(path_, key);
    EXPECT_FALSE(log.committed(5));
    log.commit(5, kept, 0, state_of(9), false);
    log.commit(6, KeptFrames(), 0, state_of(1), true);
  }
  const CommitLog log(path_, key);
  const auto found = log.committed(5);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->frames, 3u);
  EXPECT_FALSE(found->is_done);
  EXPECT_EQ(found->state.step, 9);
  EXPECT_EQ(found->state.previous, state_of(9).previous);
  EXPECT_EQ(found->state.limits_off, limits_off_);
  EXPECT_TRUE(log.committed(6)->is_done);
  EXPECT_FALSE(log.committed(7));
}

TEST_F(CommitLogs, ShowFramesBitByBit) {
  CommitLog(path_, key).commit(5, frames(2), 0, state_of(9), false);
  std::int64_t step = 0;
  CommitLog(path_, key).replay(5, [&](const Frame& shown) {
    const Frame expected = frame_of(step++);
    EXPECT_EQ(shown.step, expected.step);
    EXPECT_EQ(shown.time, expected.time);
    EXPECT_TRUE(std::ranges::equal(shown.positions, expected.positions));
    EXPECT_TRUE(std::signbit(shown.positions[0].z));
    EXPECT_TRUE(std::ranges::equal(shown.limits_off, limits_off_));
    EXPECT_EQ(shown.force, expected.force);
    EXPECT_EQ(shown.stop, Stop::max_sweeps);
    EXPECT_EQ(shown.drawn_by, DrawnBy::turns);
  });
  EXPECT_EQ(step, 2);
}

TEST_F(CommitLogs, EndAtTheFirstCommitThatIsNotWhole) {
  const KeptFrames kept = frames(4);
  std::vector<std::uintmax_t> ends;
  CommitLog log(path_, key);
  for (std::size_t first = 0; first < 4; ++first) {
    KeptFrames one;
    one.add(kept[first]);
    log.commit(0, one, 0, state_of(static_cast<std::int64_t>(first)), false, first);
    ends.push_back(fs::file_size(path_));
  }
  for (std::size_t whole = 4; whole-- > 1;) {
    fs::resize_file(path_, ends[whole] - 1);
    const CommitLog cut(path_, key);
    EXPECT_EQ(steps_in(cut, 0).size(), whole);
    EXPECT_EQ(fs::file_size(path_), ends[whole - 1]);
  }
}

TEST_F(CommitLogs, OfAnotherRunAreRefused) {
  CommitLog(path_, key).commit(5, frames(1), 0, state_of(9), false);
  EXPECT_THROW(CommitLog(path_, key + 1), InputError);
  EXPECT_TRUE(CommitLog(path_, key).committed(5));
}

TEST_F(CommitLogs, TakenAwayAreNotMadeAgain) {
  int warnings = 0;
  CommitLog log(path_, key, Log{[&](Severity, std::string_view) { ++warnings; }});
  fs::rename(path_, folder_ / "taken.log");
  for (int k = 0; k < 2; ++k) log.commit(5, frames(1), 0, state_of(9), false);
  EXPECT_EQ(warnings, 1);
  EXPECT_EQ(log.commits(), 0);
  EXPECT_FALSE(fs::exists(path_));
}

TEST_F(CommitLogs, KeysTellRunsApart) {
  FrameworkParts parts;
  parts.joint_count = 2;
  parts.bars = {{0, 1}};
  parts.rest_lengths = {1.0};
  const Framework framework(parts);
  parts.rest_lengths = {1.5};
  const Framework longer(parts);
  const std::vector<Vec3> start{{0, 0, 0}, {1, 0, 0}}, other{{0, 0, 0}, {0, 1, 0}};
  const std::vector<NamedParameter> seven{{"run/seed", std::string("7")}};
  const std::uint64_t first = key_of_run(framework, start, {});
  EXPECT_EQ(first, key_of_run(framework, start, {}));
  EXPECT_NE(first, key_of_run(longer, start, {}));
  EXPECT_NE(first, key_of_run(framework, other, {}));
  EXPECT_NE(first, key_of_run(framework, start, seven));
}

}  // namespace commit_log_test
}  // namespace pliant
