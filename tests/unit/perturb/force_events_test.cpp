// SPDX-License-Identifier: MIT
#include "pliant/perturb/force_files/force_events.hpp"

#include "pliant/lab/examples/examples.hpp"
#include "pliant/run/replay_events.hpp"
#include "pliant/run/steered_walk.hpp"
#include "support/frameworks.hpp"
#include "support/test.hpp"

namespace pliant::force_events_test {

const Framework& hexagon() {
  static const Framework framework = framework_of(ring(6));
  return framework;
}

std::vector<ForceEvent> parse(std::string_view text) {
  return parse_force_events(text, "f.txt", hexagon());
}

std::string refusal(std::string_view text) {
  return test::error_text<InputError>([&] { parse(text); });
}

constexpr std::string_view session =
    "pliant-forces 3\n"
    "set technique bfs_cycle\n"
    "set tolerance 1e-07\n"
    "pin 0 3\n"
    "force 1 40 0.1 -30\n"
    "force 4 1e-300 5 6\n"
    "step\n"
    "step\n"
    "pin\n"
    "wander 12\n";

TEST(ForceEvents, AreReadAndWrittenToTheSameBits) {
  const std::vector<ForceEvent> events = parse(session);
  ASSERT_EQ(events.size(), 7u);
  EXPECT_EQ(std::get<SetOption>(events[1].what), (SetOption{"tolerance", "1e-07"}));
  EXPECT_EQ(std::get<PinJoints>(events[2].what).joints, (std::vector<Joint>{0, 3}));
  EXPECT_EQ(std::get<PullStep>(events[3].what).forces[1].force, (Vec3{1e-300, 5, 6}));
  EXPECT_TRUE(std::get<PullStep>(events[4].what).forces.empty());
  EXPECT_EQ(events[6].line, 10u);
  EXPECT_EQ(steps_of(events), 14);
  EXPECT_EQ(write_force_events(events, hexagon()), session);
}

constexpr std::string_view edits =
    "pliant-forces 3\n"
    "cut 0 1\n"
    "force 1 40 0.1 -30\n"
    "step 3\n"
    "bar 0 3 1.75\n"
    "restore 0 1\n"
    "step 2\n";

TEST(ForceEvents, HoldEdits) {
  const std::vector<ForceEvent> events = parse(edits);
  ASSERT_EQ(events.size(), 5u);
  EXPECT_EQ(std::get<FrameworkEdit>(events[0].what), (FrameworkEdit{EditKind::cut, 0, 1}));
  EXPECT_EQ(std::get<FrameworkEdit>(events[2].what), (FrameworkEdit{EditKind::bar, 0, 3, 1.75}));
  EXPECT_EQ(std::get<FrameworkEdit>(events[3].what), (FrameworkEdit{EditKind::restore, 0, 1}));
  EXPECT_EQ(write_force_events(events, hexagon()), edits);
  EXPECT_EQ(edits_text(events, hexagon()),
            "after step 0: cut 0 - 1; after step 3: bar 0 - 3, 1.75 Angstrom; "
            "after step 3: restore 0 - 1");
  EXPECT_EQ(edits_text({}, hexagon()), "");
}

TEST(ForceEvents, EditsAreReplayedToTheBitsOfAWalk) {
  SteeredWalk walk(hexagon(), State(ring(6).positions));
  walk.start();
  const std::vector<JointForce> push{{1, {40.0, 0.1, -30.0}}};
  walk.edit(std::vector<FrameworkEdit>{{EditKind::cut, 0, 1}});
  for (int k = 0; k < 3; ++k) walk.pull(push);
  walk.edit(std::vector<FrameworkEdit>{{EditKind::bar, 0, 3, 1.75}, {EditKind::restore, 0, 1}});
  for (int k = 0; k < 2; ++k) walk.pull({});
  State state(ring(6).positions);
  const RunSummary summary = replay_events(hexagon(), state, parse(edits), {}, {});
  EXPECT_TRUE(test::same_bits(state.positions, walk.state().positions));
  EXPECT_EQ(summary.steps, 5);
  EXPECT_NEAR(distance(state.positions[0], state.positions[3]), 1.75, 1e-5);
}

TEST(ForceEvents, AreToldFromPushes) {
  EXPECT_TRUE(has_force_events(session));
  EXPECT_TRUE(has_force_events("pliant-forces 3\njoints 4\nwander 2\n"));
  EXPECT_FALSE(has_force_events("pliant-forces 3\nset timestep 1\npush 1 0 0 1\n"));
  EXPECT_TRUE(has_force_events("# of a page\n\npliant-forces 3 # version\r\npin\r\n"));
  EXPECT_FALSE(has_force_events("pliant-forces 3\n"));
  EXPECT_FALSE(has_force_events(""));
}

TEST(ForceEvents, RefusalsNameFileAndLine) {
  EXPECT_EQ(refusal(""), "f.txt: expected \"pliant-forces 3\" first, found no text");
  EXPECT_EQ(refusal("pliant-forces 4\n"),
            "f.txt:1: expected \"pliant-forces 3\", found \"pliant-forces 4\"");
  const char* count = "expected a whole number of steps from 1";
  const std::pair<const char*, std::string> cases[] = {
      {"cut 0\n", "2: cut: expected two joints, found 1 fields"},
      {"bar 0 1\n", "2: bar: expected two joints and a length, found 2 fields"},
      {"bar 0 1 -2\n", "2: bar: expected a length above 0, found \"-2\""},
      {"cut 0 9\n", "2: joint: no joint is named \"9\""},
      {"push 1 0 0 0\n",
       "2: expected set, start, hold_back, pin, cut, bar, restore, force, step or wander, found "
       "\"push\""},
      {"set technique\n", "2: set: expected a name and a value, found 1 fields"},
      {"force 1 0 0\n", "2: force: expected a joint and a force (x, y, z), found 3 fields"},
      {"force 1 0 nan 0\nstep\n",
       "2: force y: expected a finite number up to 1e100, found \"nan\""},
      {"force 1 0 0 1\npin 2\n", "3: expected force, step or wander after a force, found \"pin\""},
      {"force 1 0 0 1\n", "2: force: no step follows it"},
      {"pin 6\n", "2: joint: no joint is named \"6\""},
      {"wander 0\n", std::string("2: wander: ") + count},
      {"step 0\n", std::string("2: step: ") + count},
      {"step -1\n", std::string("2: step: ") + count},
      {"step x\n", std::string("2: step: ") + count},
      {"step 1 2\n", std::string("2: step: ") + count},
      {"step 9223372036854775807\n", std::string("2: step: ") + count},
      {"hold_back 0\n", "2: hold_back: expected a number above 0"},
      {"step\nstart\n", "3: start: expected before all but set"},
  };
  for (const auto& [lines, fault] : cases)
    EXPECT_EQ(refusal("pliant-forces 3\n" + std::string(lines)), "f.txt:" + fault);
}

TEST(ForceEvents, CountStepsThatAreTheSame) {
  const std::string text =
      "pliant-forces 3\nset seed 7\nstart\nhold_back 0.2\nforce 1 0 0 2\nstep 350\n"
      "force 1 0 0 2\nwander 20\nwander 5\n";
  const std::vector<ForceEvent> events = parse(text);
  EXPECT_EQ(steps_of(events), 375);
  EXPECT_EQ(write_force_events(events, hexagon()), text);
  std::vector<ForceEvent> added;
  const std::vector<JointForce> zero{{1, {0.0, 0.0, 0.0}}}, minus{{1, {0.0, 0.0, -0.0}}};
  for (int k = 0; k < 1000; ++k) add_pull(added, zero);
  add_pull(added, minus);
  for (int k = 0; k < 3; ++k) add_wander(added);
  EXPECT_EQ(write_force_events(added, hexagon()),
            "pliant-forces 3\nforce 1 0 0 0\nstep 1000\nforce 1 0 0 -0\nstep\nwander 3\n");
}

TEST(ReplayEvents, CountedStepsHaveTheBitsOfThoseWrittenOut) {
  const std::string pull = "force 1 40 0.1 -30\n";
  std::string written = "pliant-forces 3\nset damping 0.5\n";
  for (int k = 0; k < 30; ++k) written += pull + "step\n";
  State counted(ring(6).positions), listed(ring(6).positions);
  replay_events(hexagon(), counted,
                parse("pliant-forces 3\nset damping 0.5\n" + pull + "step 30\n"), {}, {});
  replay_events(hexagon(), listed, parse(written), {}, {});
  EXPECT_EQ(counted.positions, listed.positions);
  EXPECT_EQ(counted.step, 30);
}

TEST(ReplayEvents, RefusalsNameTheLine) {
  const std::pair<const char*, const char*> cases[] = {
      {"step\ncut 0 2\nstep\n", "3: cut 0 - 2: neither a bar nor a contact joins them"},
      {"restore 0 1\nstep\n", "2: restore 0 - 1: is as it was at the start"},
      {"step\nset weighting 2\nstep\n", "3: weighting = 2: must be from 0 to 1"},
      {"set weighting half\n", "2: weighting: expected a number, found \"half\""},
      {"set mass_weighted 1\n", "2: mass_weighted: expected true or false, found \"1\""}};
  for (const auto& [lines, fault] : cases) {
    State state(ring(6).positions);
    const auto events = parse("pliant-forces 3\n" + std::string(lines));
    EXPECT_ERROR(InputError, "f.txt:" + std::string(fault),
                 replay_events(hexagon(), state, events, {.file = "f.txt"}, {}));
  }
}

/// Shown are step 0, every third, and the last.
TEST(ReplayEvents, ShowsWhatARunShows) {
  State state(ring(6).positions);
  std::vector<std::int64_t> shown;
  const RunSummary summary =
      replay_events(hexagon(), state, parse(session), {.every = 3}, {[&](const Frame& frame) {
                      shown.push_back(frame.step);
                      return false;
                    }});
  EXPECT_EQ(shown, (std::vector<std::int64_t>{0, 3, 6, 9, 12, 14}));
  EXPECT_EQ(summary.steps, 14);
  EXPECT_EQ(summary.frames, 6);
  EXPECT_EQ(state.step, 14);
}

TEST(ReplayEvents, EndsWhereAnObserverAsks) {
  State state(ring(6).positions);
  const RunSummary summary = replay_events(hexagon(), state, parse(session), {},
                                           {[](const Frame& frame) { return frame.step == 5; }});
  EXPECT_TRUE(summary.stopped_by_caller);
  EXPECT_EQ(state.step, 5);
}

}  // namespace pliant::force_events_test
