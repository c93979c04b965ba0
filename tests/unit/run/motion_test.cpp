// SPDX-License-Identifier: MIT
#include "pliant/run/motion.hpp"

#include "pliant/framework/measures/residual.hpp"
#include "pliant/lab/examples/examples.hpp"
#include "pliant/perturb/steering.hpp"
#include "pliant/run/run.hpp"
#include "pliant/run/run_fields.hpp"
#include "support/frameworks.hpp"
#include "support/test.hpp"

namespace pliant::motion_test {

MotionOptions by(std::vector<std::string> push, const char* technique = "bfs_cycle") {
  return {.technique = {.name = technique}, .push = std::move(push)};
}

/// run() is a loop over it.
TEST(Motion, StepsAsARunDoes) {
  const Framework framework = framework_of(ring(7));
  for (const char* technique : {"bfs_cycle", "blocks", "random"})
    for (const char* push : {"force", "force_all", "displacement"}) {
      State state(ring(7).positions);
      RunOptions options{
          .technique = {.name = technique}, .resolve = {.walker = 2}, .perturb = push, .steps = 20};
      Motion motion(framework, State(ring(7).positions), by({push}, technique), 2);
      bool has_begun = false;
      run(framework, state, options, {[&](const Frame& frame) {
            const Frame own = has_begun ? motion.step() : motion.start();
            has_begun = true;
            EXPECT_TRUE(test::same_bits(frame.positions, own.positions));
            EXPECT_EQ(frame.step, own.step);
            EXPECT_EQ(frame.time, own.time);
            EXPECT_EQ(frame.sweeps, own.sweeps);
            EXPECT_EQ(frame.max_residual, own.max_residual);
            EXPECT_EQ(frame.rms_residual, own.rms_residual);
            EXPECT_EQ(frame.root_joint, own.root_joint);
            EXPECT_EQ(frame.force, own.force);
            return false;
          }});
      EXPECT_EQ(motion.summary().steps, 20);
      EXPECT_EQ(motion.summary().frames, 21);
      EXPECT_TRUE(test::same_bits(motion.state().previous, state.previous));
    }
}

TEST(Motion, StepsOnAStateThatLivesElsewhere) {
  const Framework framework = framework_of(ring(5));
  State state(ring(5).positions);
  Motion lent(framework, std::ref(state), by({"force"}));
  Motion own(framework, State(ring(5).positions), by({"force"}));
  lent.step();
  own.step();
  EXPECT_TRUE(test::same_bits(state.positions, own.state().positions));
  EXPECT_EQ(state.step, 1);
}

TEST(Motion, IsOverWithTheLastForceOfAReplay) {
  const Framework framework = framework_of(ring(5));
  MotionOptions options = by({"replay"});
  options.replay = {{2, {1, 0, 0}}, {4, {0, 2, 0}}};
  Motion motion(framework, State(ring(5).positions), options);
  motion.start();
  EXPECT_FALSE(motion.is_over());
  EXPECT_EQ(motion.step().root_joint, 2);
  EXPECT_FALSE(motion.is_over());
  EXPECT_EQ(motion.step().root_joint, 4);
  EXPECT_TRUE(motion.is_over());
  motion.add(std::make_shared<Steering>());
  EXPECT_FALSE(motion.is_over());
}

TEST(Motion, NobodyPushesAndNothingMoves) {
  const Framework framework = framework_of(ring(6));
  for (const char* technique : {"bfs_cycle", "blocks", "newton"}) {
    Motion motion(framework, State(ring(6).positions), by({}, technique));
    for (int step = 1; step < 4; ++step) {
      const Frame frame = motion.step();
      EXPECT_EQ(frame.step, step);
      EXPECT_EQ(frame.stop, Stop::converged);
      EXPECT_EQ(frame.sweeps, 0);
      EXPECT_EQ(frame.root_joint, no_joint);
      EXPECT_EQ(frame.max_residual, measure(framework, ring(6).positions).max_relative);
      EXPECT_TRUE(test::same_bits(frame.positions, ring(6).positions));
    }
  }
}

/// Where few joints were pushed only their surroundings are looked at: not if somebody else moved
/// some.
TEST(Motion, SeesWhatSomebodyElseChanged) {
  const Sketch sketch = shaken(chain(60), 0.2);
  const Framework framework = framework_of(sketch);
  Motion motion(framework, State(sketch.positions), by({"force"}, "blocks"));
  for (int step = 0; step < 5; ++step) motion.step();
  motion.change_state().positions[30] += Vec3{0.1, 0.2, 0.3};
  const Frame frame = motion.step();
  EXPECT_EQ(frame.stop, Stop::converged);
  EXPECT_LE(measure(framework, frame.positions).max_relative, 1e-6);
}

TEST(Motion, AStepThatIsCutShortIsTakenBack) {
  const Framework framework = framework_of(ring(9));
  MotionOptions options = by({"displacement"});
  bool stops = false;
  options.resolve.should_stop = [&] { return stops; };
  Motion motion(framework, State(ring(9).positions), options);
  motion.step();
  motion.step();
  const State before = motion.state();
  stops = true;
  const Frame frame = motion.step();
  EXPECT_EQ(frame.stop, Stop::stopped_by_caller);
  EXPECT_EQ(frame.step, 2);
  EXPECT_EQ(frame.root_joint, no_joint);
  EXPECT_LE(frame.max_residual, 1e-6);
  EXPECT_TRUE(motion.is_over());
  EXPECT_TRUE(test::same_bits(motion.state().positions, before.positions));
  EXPECT_TRUE(test::same_bits(motion.state().previous, before.previous));
  stops = false;
  EXPECT_EQ(motion.step().step, 3);
  EXPECT_FALSE(motion.is_over());
}

TEST(Motion, RefusesWhatCannotBe) {
  const Framework framework = framework_of(chain(3));
  EXPECT_ERROR(OptionError,
               "no pusher named \"forces\" (did you mean \"force\"?); known: force, force_all, "
               "displacement, replay, rock, pull, pair_distance",
               Motion(framework, State(chain(3).positions), by({"forces"})));
}

std::string refusal(const RunOptions& options) {
  return test::error_text<OptionError>([&] { check(options); });
}

TEST(RunFields, EachHasANamePlaceAndSummaryOfItsOwn) {
  RunOptions options;
  std::set<std::string_view> names;
  std::set<const void*> places;
  for (const RunField& field : run_fields()) {
    EXPECT_TRUE(names.insert(field.name).second) << field.name;
    EXPECT_TRUE(places
                    .insert(std::visit([](auto* place) -> const void* { return place; },
                                       field.place(options)))
                    .second)
        << field.name;
    EXPECT_FALSE(field.summary.empty());
    EXPECT_EQ(std::holds_alternative<std::string*>(field.place(options)), field.choices != nullptr);
  }
}

/// What lies out of its range is refused by name, whichever option it is.
TEST(RunFields, EveryNumberIsHeldToItsRange) {
  EXPECT_NO_THROW(check(RunOptions{}));
  for (const RunField& field : run_fields()) {
    SCOPED_TRACE(field.name);
    RunOptions options;
    const OptionPlace place = field.place(options);
    const auto expect_refused = [&] {
      EXPECT_THAT(refusal(options), testing::StartsWith(std::string(field.name) + " = "));
    };
    if (auto* real = std::get_if<double*>(&place)) {
      for (const double value : {-0.5, std::nan(""), HUGE_VAL}) {
        **real = value;
        expect_refused();
      }
    } else if (auto* whole = std::get_if<std::int64_t*>(&place)) {
      **whole = -1;
      expect_refused();
    }
  }
  EXPECT_EQ(refusal({.technique = {"bfs_cycle", 2.0}}), "weighting = 2: must be from 0 to 1");
}

TEST(RunFields, UnknownNamesAreRefusedWithTheKnownOnes) {
  EXPECT_THAT(refusal({.perturb = "forse"}),
              testing::StartsWith("no perturbation named \"forse\" (did you mean \"force\"?)"));
}

TEST(RunFields, ParametersAreAllOptions) {
  const Framework framework = framework_of(chain(4));
  const std::vector<NamedParameter> list = parameters_of(
      {.resolve = {.max_sweeps = 7, .seed = 18446744073709551615u}, .replay = {{0, {1, 0, 0}}}},
      framework);
  const std::map<std::string, Parameter> values(list.begin(), list.end());
  EXPECT_EQ(values.size(), run_fields().size() + 2);
  EXPECT_EQ(values.at("run/seed"), Parameter(std::string("18446744073709551615")));
  EXPECT_EQ(values.at("run/max_sweeps"), Parameter(std::int64_t{7}));
  EXPECT_EQ(values.at("run/perturb"), Parameter(std::string("replay")));
  EXPECT_EQ(values.at("run/technique"), Parameter(std::string("auto")));
  EXPECT_EQ(values.at("run/technique_used"), Parameter(std::string("blocks")));
}

}  // namespace pliant::motion_test
