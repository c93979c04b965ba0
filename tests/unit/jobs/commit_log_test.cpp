// SPDX-License-Identifier: MIT
#include "pliant/jobs/files/commit_log.hpp"

#include "pliant/jobs/files/force_recorder.hpp"
#include "pliant/perturb/force_files/force_events.hpp"
#include "pliant/perturb/steering.hpp"
#include "pliant/run/force_settings.hpp"
#include "pliant/run/replay_events.hpp"
#include "pliant/text/file_text.hpp"
#include "support/test.hpp"

namespace pliant::commit_log_test {

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
  FrameworkParts parts{.joint_count = 2, .bars = {{0, 1}}, .rest_lengths = {1.0}};
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

class ForceRecords : public testing::Test {
 protected:
  static FrameworkParts pair() {
    return {.joint_count = 2, .bars = {{0, 1}}, .rest_lengths = {1.0}};
  }

  const test::TempDirectory folder_;
  const fs::path path_ = folder_ / "f.txt";
  const Framework framework_{pair()};
};

TEST_F(ForceRecords, AreThereAsAWholeOncePublished) {
  ForceFile settings;
  settings.timestep = 0.25;
  ForceRecorder recorder(path_, false, framework_, settings);
  recorder.record({1, {1.0, -2.0, 0.1}, true});
  recorder.record({0, {0.0, 3.0, 0.0}, true});
  EXPECT_FALSE(fs::exists(path_));
  recorder.publish();
  const ForceFile back = read_force_file(path_, framework_);
  EXPECT_EQ(back.timestep, 0.25);
  EXPECT_EQ(back.max_sweeps, std::nullopt);
  ASSERT_EQ(back.pushes.size(), 2u);
  EXPECT_EQ(back.pushes[0].joint, 1u);
  EXPECT_EQ(back.pushes[0].force, (Vec3{1.0, -2.0, 0.1}));
  EXPECT_EQ(back.pushes[1].joint, 0u);
}

TEST_F(ForceRecords, HoldAllForcesOfAStep) {
  ForceRecorder recorder(path_, false, framework_, {});
  Push push;
  recorder.record(push);
  push.add(1, {1.0, 0.0, 0.0});
  push.forces = {{1, {1.0, 0.0, 0.0}}, {0, {0.0, 2.0, 0.0}}};
  recorder.record(push);
  recorder.publish();
  const auto back = parse_force_events(read_bytes(path_), "f.txt", framework_);
  ASSERT_EQ(back.size(), 2u);
  EXPECT_TRUE(std::get<PullStep>(back[0].what).forces.empty());
  EXPECT_EQ(std::get<PullStep>(back[1].what).forces.size(), 2u);
  EXPECT_EQ(std::get<PullStep>(back[1].what).forces[1].joint, 0u);
}

/// A hand that pulls for 10^5 steps, held back by other forces in each: what it asked for is kept.
TEST_F(ForceRecords, OfAHandCountStepsInWhichNothingChanged) {
  ForceRecorder recorder(path_, false, framework_, {}, 0.2);
  Push alone;
  alone.forces = {{0, {1.0, 2.0, 3.0}}};
  Push pulled;
  pulled.asked = {{1, {0.0, 0.0, 9.0}}};
  recorder.record(alone);
  recorder.record(alone);
  for (int k = 0; k < 100000; ++k) {
    pulled.forces = {{0, {0.0, 0.0, 0.0}}, {1, {0.0, 0.0, 1.0 / (k + 1)}}};
    recorder.record(pulled);
  }
  recorder.record(alone);
  recorder.publish();
  EXPECT_EQ(read_bytes(path_),
            "pliant-forces 3\nstart\nhold_back 0.2\nwander 2\nforce 1 0 0 9\nwander 100000\n"
            "wander 1\n");
}

/// The file of a run of 10^5 steps that a hand pulls on, all the time held back, and which random
/// forces push as well, is small; replayed, it has the bits of the run.
TEST_F(ForceRecords, OfAHandAreReplayedToTheSameBits) {
  RunOptions options{.steps = 100000};
  options.every = options.steps;
  options.perturb_options.damping = 0.5;
  options.resolve.seed = 11;
  options.hands = {std::make_shared<Steering>(0.2)};
  static_cast<Steering&>(*options.hands[0]).pull(std::vector<JointForce>{{1, {300.0, 9e5, -7.0}}});
  ForceFile settings;
  settings.set(options.perturb_options, options.resolve.tolerance, options.resolve.max_sweeps);
  settings.settings = force_settings(options);
  ForceRecorder recorder(path_, false, framework_, settings, 0.2);
  options.on_push = [&](const Push& push) { recorder.record(push); };
  State live(std::vector<Vec3>{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}});
  State again = live;
  run(framework_, live, options, {});
  recorder.publish();
  const std::string text = read_bytes(path_);
  EXPECT_LT(text.size(), 300u);
  replay_events(framework_, again, parse_force_events(text, "f.txt", framework_),
                {.every = options.every}, {});
  EXPECT_EQ(live.step, again.step);
  EXPECT_EQ(live.positions, again.positions);
}

TEST_F(ForceRecords, LeaveNothingBehindUnlessPublished) {
  { ForceRecorder recorder(path_, false, framework_, {}); }
  EXPECT_TRUE(fs::is_empty(folder_.path()));
}

TEST_F(ForceRecords, ReplaceNoFileUnasked) {
  std::ofstream(path_) << "mine";
  const auto make = [&] { ForceRecorder recorder(path_, false, framework_, {}); };
  EXPECT_NE(test::error_text<FileError>(make).find("f.txt: exists"), std::string::npos);
  EXPECT_NO_THROW(ForceRecorder(path_, true, framework_, {}).publish());
}

}  // namespace pliant::commit_log_test
