// SPDX-License-Identifier: MIT
#include "pliant/run/run.hpp"

#include "pliant/framework/measures/residual.hpp"
#include "pliant/lab/examples/examples.hpp"
#include "support/frameworks.hpp"
#include "support/test.hpp"

namespace pliant::run_test {

/// A frame whose positions outlive the call.
struct Shown {
  Frame frame;
  std::vector<Vec3> positions;
};

struct Story {
  RunSummary summary;
  std::vector<Shown> frames;
  State state;
  std::string said;
};

Story tell(const Framework& framework, State state, RunOptions options, const Observer& also = {}) {
  Story story;
  options.log = {[&](Severity, std::string_view text) { story.said += text; }};
  const Observer keep = [&](const Frame& frame) {
    story.frames.push_back({frame, {frame.positions.begin(), frame.positions.end()}});
    return false;
  };
  std::vector<Observer> observers{keep};
  if (also) observers.push_back(also);
  story.summary = run(framework, state, options, observers);
  story.state = std::move(state);
  return story;
}

RunOptions displacing(std::int64_t steps) {
  return {.technique = {.name = "bfs_cycle"}, .perturb = "displacement", .steps = steps};
}

TEST(Run, ShowsTheStartEachStepAndTrueNumbers) {
  const Framework framework = framework_of(ring(6));
  const Story story = tell(framework, State(ring(6).positions), displacing(30));
  ASSERT_EQ(story.frames.size(), 31u);
  EXPECT_EQ(story.summary.frames, 31);
  EXPECT_EQ(story.summary.steps, 30);
  EXPECT_EQ(story.summary.unconverged_steps, 0);
  EXPECT_EQ(story.summary.first_unconverged_step, -1);
  EXPECT_FALSE(story.summary.stopped_by_caller);
  EXPECT_EQ(story.frames[0].frame.root_joint, no_joint);
  EXPECT_EQ(story.frames[0].positions, ring(6).positions);
  std::int64_t sweeps = 0, most = 0, projections = 0;
  double worst = 0.0;
  for (std::size_t k = 0; k < story.frames.size(); ++k) {
    const auto& [frame, positions] = story.frames[k];
    const ResidualSummary found = measure(framework, positions);
    EXPECT_EQ(frame.step, std::int64_t(k));
    EXPECT_NEAR(frame.time, 0.01 * double(k), 1e-12);
    EXPECT_EQ(frame.stop, Stop::converged);
    EXPECT_EQ(frame.max_residual, found.max_relative);
    EXPECT_EQ(frame.rms_residual, found.rms_relative);
    EXPECT_LE(frame.max_residual, 1e-6);
    sweeps += frame.sweeps;
    projections += frame.projections;
    most = std::max(most, frame.sweeps);
    worst = std::max(worst, frame.max_residual);
  }
  EXPECT_EQ(story.summary.sweeps, sweeps);
  EXPECT_EQ(story.summary.max_sweeps, most);
  EXPECT_EQ(story.summary.projections, projections);
  EXPECT_EQ(story.summary.worst_residual, worst);
  EXPECT_DOUBLE_EQ(story.summary.mean_sweeps(), double(sweeps) / 30.0);
  EXPECT_GT(story.summary.ns_per_bar_and_sweep(), 0.0);
  EXPECT_EQ(story.state.positions, story.frames.back().positions);
}

TEST(Run, ShowsEverySoManyStepsAndTheLast) {
  RunOptions options = displacing(10);
  options.every = 4;
  const Story story = tell(framework_of(ring(5)), State(ring(5).positions), options);
  std::vector<std::int64_t> steps;
  for (const Shown& shown : story.frames) steps.push_back(shown.frame.step);
  EXPECT_EQ(steps, (std::vector<std::int64_t>{0, 4, 8, 10}));
}

TEST(Run, OnlookersSeeWhatTheyWantWhateverIsShown) {
  const Framework framework = framework_of(ring(6));
  RunOptions options = displacing(10);
  const Story alone = tell(framework, State(ring(6).positions), options);
  options.every = 4;
  std::vector<std::int64_t> seen;
  std::vector<std::vector<Vec3>> places;
  options.onlooker.wants = [](std::int64_t step) { return step % 3 == 0; };
  options.onlooker.look = [&](const Frame& frame) {
    seen.push_back(frame.step);
    places.emplace_back(frame.positions.begin(), frame.positions.end());
    EXPECT_GT(frame.rms_residual, -1.0);
  };
  const Story story = tell(framework, State(ring(6).positions), options);
  EXPECT_EQ(seen, (std::vector<std::int64_t>{0, 3, 6, 9}));
  EXPECT_EQ(story.summary.frames, 4) << "steps 0, 4, 8 and the last: an onlooker is no observer";
  for (std::size_t k = 0; k < seen.size(); ++k)
    EXPECT_TRUE(test::same_bits(places[k], alone.frames[std::size_t(seen[k])].positions));
  EXPECT_TRUE(test::same_bits(story.state.positions, alone.state.positions));
}

TEST(Run, NoStepsShowTheStart) {
  const Story story = tell(framework_of(ring(5)), State(ring(5).positions), displacing(0));
  EXPECT_EQ(story.frames.size(), 1u);
  EXPECT_EQ(story.summary.mean_sweeps(), 0.0);
  EXPECT_EQ(story.summary.ns_per_bar_and_sweep(), 0.0);
}

/// A broken start is resolved first and reported, and its sweeps are no step's.
TEST(Run, ResolvesABrokenStart) {
  const Framework framework = framework_of(ring(5));
  State state(ring(5).positions);
  state.positions[2] += Vec3{0, 0, 0.5};
  const Story story = tell(framework, state, displacing(0));
  EXPECT_EQ(story.said,
            "the start misses its rest lengths, worst bar 1 - 2 by 0.118 Angstrom: resolved "
            "first");
  EXPECT_LE(story.frames[0].frame.max_residual, 1e-6);
  EXPECT_GT(story.frames[0].frame.sweeps, 0);
  EXPECT_EQ(story.summary.sweeps, 0);
  EXPECT_EQ(story.state.previous, story.state.positions) << "and is at rest";
}

TEST(Run, WalkersGoTheirOwnWays) {
  RunOptions options = displacing(3);
  const Framework framework = framework_of(ring(7));
  const Story one = tell(framework, State(ring(7).positions), options);
  options.resolve.walker = 1;
  const Story other = tell(framework, State(ring(7).positions), options);
  EXPECT_FALSE(test::same_bits(one.state.positions, other.state.positions));
}

TEST(Run, CountsStepsThatDoNotConvergeAndGoesOn) {
  RunOptions options = displacing(5);
  options.resolve.max_sweeps = 1;
  const Story story = tell(framework_of(ring(9)), State(ring(9).positions), options);
  EXPECT_EQ(story.summary.steps, 5);
  EXPECT_EQ(story.summary.unconverged_steps, 5);
  EXPECT_EQ(story.summary.first_unconverged_step, 1);
  EXPECT_EQ(story.frames[3].frame.stop, Stop::max_sweeps);
  EXPECT_GT(story.frames[3].frame.max_residual, 1e-6);
}

/// A push that overflows is taken back: no frame ever holds what is not a number.
TEST(Run, TakesBackPushesThatOverflow) {
  for (const char* perturbation : {"force", "force_all"}) {
    for (double force : {1e160, 1e300, 1.7e308}) {
      const RunOptions options{.perturb = perturbation,
                               .perturb_options = {.force = force, .timestep = 1.0},
                               .steps = 3};
      FrameworkParts parts = test::parts_of(framework_of(ring(5)));
      parts.joint_count = 6;  // one joint without bars
      parts.masses.clear();
      std::vector<Vec3> start = ring(5).positions;
      start.push_back({3, 3, 3});
      const Story story = tell(Framework(std::move(parts)), State(start), options);
      EXPECT_EQ(story.frames.size(), 4u);
      EXPECT_EQ(story.summary.unconverged_steps, 3);
      for (const auto& [frame, positions] : story.frames) {
        EXPECT_EQ(frame.stop, frame.step == 0 ? Stop::converged : Stop::not_finite);
        EXPECT_EQ(positions, start) << perturbation << force;
        EXPECT_LE(frame.max_residual, 1e-6);
      }
    }
  }
}

TEST(Run, ReplaysForcesOneAStep) {
  const Framework framework = framework_of(ring(5));
  RunOptions options{.replay = {{2, {1, 0, 0}}, {4, {0, 2, 0}}, {0, {0, 0, 3}}}};
  const Story story = tell(framework, State(ring(5).positions), options);
  ASSERT_EQ(story.frames.size(), 4u) << "the run ends with the last force";
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(story.frames[k + 1].frame.root_joint, std::int64_t(options.replay[k].joint));
    EXPECT_EQ(story.frames[k + 1].frame.force, options.replay[k].force);
  }
  options.steps = 2;
  EXPECT_EQ(tell(framework, State(ring(5).positions), options).frames.size(), 3u);
}

TEST(Run, ObserversCanStopIt) {
  const Story story = tell(framework_of(ring(5)), State(ring(5).positions), displacing(100),
                           [](const Frame& frame) { return frame.step == 7; });
  EXPECT_EQ(story.summary.steps, 7);
  EXPECT_EQ(story.frames.back().frame.step, 7);
  EXPECT_TRUE(story.summary.stopped_by_caller);
}

TEST(Run, ErrorsOfObserversPassThrough) {
  State state(ring(5).positions);
  EXPECT_THROW(run(framework_of(ring(5)), state, displacing(3),
                   {[](const Frame&) -> bool { throw FileError("full"); }}),
               FileError);
}

/// A step that is stopped in its sweeps leaves the state of the step before; its push is none of
/// the run's.
TEST(Run, AStepCutShortIsUndone) {
  const Framework framework = framework_of(ring(9));
  RunOptions options = displacing(10);
  int asked = 0, pushed = 0;
  options.resolve.should_stop = [&] { return ++asked == 20; };
  options.on_push = [&](const Push&) { ++pushed; };
  const Story story = tell(framework, State(ring(9).positions), options);
  EXPECT_TRUE(story.summary.stopped_by_caller);
  EXPECT_LT(story.summary.steps, 10);
  EXPECT_EQ(pushed, story.summary.steps);
  EXPECT_EQ(story.summary.unconverged_steps, 0);
  EXPECT_EQ(story.frames.back().frame.step, story.state.step);
  EXPECT_EQ(story.frames.back().frame.time, story.state.time);
  EXPECT_TRUE(test::same_bits(story.frames.back().positions, story.state.positions));
}

TEST(Run, AStartThatIsCutShortIsTheLastFrame) {
  const Example& example = find_example("pinned_ends_taut_10");
  RunOptions options = displacing(10);
  options.resolve.should_stop = [] { return true; };
  const Story story = tell(example.framework, State(example.positions), options);
  EXPECT_EQ(story.summary.steps, 0);
  EXPECT_TRUE(story.summary.stopped_by_caller);
  EXPECT_EQ(story.frames.size(), 1u);
  EXPECT_EQ(story.frames[0].frame.stop, Stop::stopped_by_caller);
}

TEST(Run, RefusesATimeThatIsNotFinite) {
  State state(chain(3).positions);
  const RunOptions options{.perturb_options = {.timestep = 1e308}, .steps = 10};
  EXPECT_ERROR(OptionError, "timestep = 1e+308: the time of 10 steps is not finite",
               run(framework_of(chain(3)), state, options, {}));
}

TEST(Run, RefusesStatesThatCannotCarryTheFramework) {
  const Framework framework = framework_of(chain(3));
  const auto refusal_of = [&](State state) {
    return test::error_text<InputError>([&] { run(framework, state, {}, {}); });
  };
  EXPECT_EQ(refusal_of(State(chain(2).positions)), "framework: 3 joints but 2 positions");
  State state(chain(3).positions);
  state.previous.clear();
  EXPECT_EQ(refusal_of(state), "framework: 3 joints but 0 previous positions");
  state = State(chain(3).positions);
  state.previous[1].y = HUGE_VAL;
  EXPECT_EQ(refusal_of(state), "previous position of joint 1 is not finite");
  state = State(chain(3).positions);
  state.positions[2].x = std::nan("");
  EXPECT_EQ(refusal_of(state), "position of joint 2 is not finite");
  State nothing;
  EXPECT_ERROR(InputError, "nothing to run: no joints", run(Framework({}), nothing, {}, {}));
}

/// Every push is reported, whether its frame is shown or not, and replaying them gives the same
/// bits.
TEST(Run, TellsThePushesThatReplayIt) {
  const Framework framework = framework_of(ring(6));
  RunOptions options{.technique = {.name = "random"}, .steps = 12, .every = 5};
  std::vector<JointForce> pushes;
  options.on_push = [&](const Push& push) {
    pushes.push_back({static_cast<Joint>(push.root_joint), push.force});
  };
  const Story first = tell(framework, State(ring(6).positions), options);
  ASSERT_EQ(pushes.size(), 12u);
  options.on_push = {};
  options.replay = pushes;
  const Story second = tell(framework, State(ring(6).positions), options);
  EXPECT_TRUE(test::same_bits(first.state.positions, second.state.positions));
  EXPECT_EQ(first.summary.sweeps, second.summary.sweeps);
}

/// Steps that look only where a push reaches show frames and keep Verlet's memory as others do.
TEST(Run, OfLocalTechniquesShowsTrueNumbersToo) {
  const Sketch sketch = shaken(chain(60), 0.2);
  const Framework framework = framework_of(sketch);
  for (const char* name : {"blocks", "auto"}) {
    RunOptions options{.technique = {.name = name}, .steps = 40};
    const Story story = tell(framework, State(sketch.positions), options);
    ASSERT_EQ(story.frames.size(), 41u);
    for (const Shown& shown : story.frames) {
      const ResidualSummary now = measure(framework, shown.positions);
      EXPECT_EQ(shown.frame.max_residual, now.max_relative);
      EXPECT_EQ(shown.frame.rms_residual, now.rms_relative);
      EXPECT_LE(now.max_relative, 1e-6);
    }
    EXPECT_EQ(story.state.positions, story.frames[40].positions) << name;
    EXPECT_EQ(story.state.previous, story.frames[39].positions) << name;
    options.every = 40;
    const Story seldom = tell(framework, State(sketch.positions), options);
    EXPECT_EQ(seldom.state.positions, story.state.positions) << name;
    EXPECT_EQ(seldom.summary.worst_residual, story.summary.worst_residual) << name;
  }
}

}  // namespace pliant::run_test
