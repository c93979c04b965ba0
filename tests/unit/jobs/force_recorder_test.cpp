// SPDX-License-Identifier: MIT
#include "pliant/jobs/files/force_recorder.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "pliant/base/error.hpp"
#include "pliant/perturb/force_files/force_events.hpp"
#include "pliant/perturb/steering.hpp"
#include "pliant/run/force_settings.hpp"
#include "pliant/run/replay_events.hpp"
#include "pliant/text/file_text.hpp"
#include "support/error_text.hpp"
#include "support/temp_directory.hpp"

namespace pliant {
namespace force_recorder_test {

namespace fs = std::filesystem;

class ForceRecords : public testing::Test {
 protected:
  static FrameworkParts pair() {
    FrameworkParts parts;
    parts.joint_count = 2;
    parts.bars = {{0, 1}};
    parts.rest_lengths = {1.0};
    return parts;
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
  RunOptions options;
  options.steps = 100000;
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
  ReplayOptions replay;
  replay.every = options.every;
  replay_events(framework_, again, parse_force_events(text, "f.txt", framework_), replay, {});
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

}  // namespace force_recorder_test
}  // namespace pliant
