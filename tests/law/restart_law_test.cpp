// SPDX-License-Identifier: MIT
// The state of a walker is all that its way depends on: n + m steps are n steps, a copy of the
// state in a new Motion, and m steps, bit by bit, whatever the technique and the pushers, and also
// where steps do not converge, or are cut short. So does a run that goes on from its H5MD file:
// positions and observables are those of one run without an end between.
#include "law/technique_cases.hpp"
#include "pliant/run/motion.hpp"
#include "support/test.hpp"
#include "unit/record/recorded_runs.hpp"
#include "unit/record/samples.hpp"

namespace pliant::restart_law_test {

using Names = std::vector<std::string>;
using test::go_on;
using test::record_run;
using test::TempDirectory;

class RestartLaw : public test::TechniqueLaw {
 protected:
  static MotionOptions options_of(const Framework& framework, const Names& push) {
    MotionOptions options{
        .technique = plain(),
        .resolve = {.max_sweeps = 25, .seed = 11},
        .push = push,
        .perturb = {.timestep = 0.02, .displacement = 0.5 * test::small_break(framework)}};
    const auto last = static_cast<Joint>(framework.joint_count() - 1);
    options.replay = {{0, {20, 0, 0}}, {last, {0, 9, 0}}, {last, {0, 5, 5}}, {0, {1, 1, 1}}};
    options.guide = test::guide_of(framework);
    return options;
  }

  static void each_push(const auto& look) {
    for (const Names& push : {Names{"force"},
                              {"force_all"},
                              {"displacement"},
                              {"replay"},
                              {"rock"},
                              {"pull", "pair_distance"},
                              {"force", "force"},
                              {"replay", "force"},
                              {"force", "displacement"}}) {
      std::string all;
      for (const std::string& name : push) all += name + " ";
      SCOPED_TRACE(all);
      look(push);
    }
  }
};

void expect_same(const State& one, const State& other) {
  EXPECT_TRUE(test::same_bits(one.positions, other.positions));
  EXPECT_TRUE(test::same_bits(one.previous, other.previous));
  EXPECT_EQ(one.step, other.step);
  EXPECT_EQ(one.time, other.time);
}

/// What observers see, but for positions.
void expect_same(const Frame& one, const Frame& other) {
  EXPECT_EQ(one.sweeps, other.sweeps);
  EXPECT_EQ(one.projections, other.projections);
  EXPECT_EQ(one.max_residual, other.max_residual);
  EXPECT_EQ(one.rms_residual, other.rms_residual);
  EXPECT_EQ(one.stop, other.stop);
  EXPECT_EQ(one.root_joint, other.root_joint);
  EXPECT_EQ(one.max_limit, other.max_limit);
  EXPECT_EQ(one.max_overlap, other.max_overlap);
}

TEST_P(RestartLaw, StepsOnAsIfNothingHadHappened) {
  each_example([](const Example& example) {
    if (example.framework.joint_count() == 0) return;
    each_push([&](const Names& push) {
      const MotionOptions options = options_of(example.framework, push);
      Motion whole(example.framework, State(example.positions), options, 3);
      whole.start();
      for (int step = 0; step < 2; ++step) whole.advance();
      Motion second(example.framework, whole.state(), options, 3);
      for (int step = 0; step < 3; ++step) {
        expect_same(whole.step(), second.step());
        expect_same(whole.state(), second.state());
      }
    });
  });
}

/// Whatever moment it is that somebody asks to stop at.
TEST_P(RestartLaw, AStepThatIsCutShortNeverWas) {
  each_example([](const Example& example) {
    if (example.framework.joint_count() == 0) return;
    each_push([&](const Names& push) {
      MotionOptions options = options_of(example.framework, push);
      Motion undisturbed(example.framework, State(example.positions), options);
      bool stops = false;
      options.resolve.should_stop = [&] { return stops; };
      Motion stopped(example.framework, State(example.positions), options);
      for (int step = 0; step < 4; ++step) {
        const State before = stopped.state();
        stops = true;
        if (!stopped.advance()) {
          expect_same(stopped.state(), before);
          stops = false;
          stopped.advance();
        }
        undisturbed.advance();
        expect_same(stopped.state(), undisturbed.state());
      }
    });
  });
}

PLIANT_FOR_ALL_TECHNIQUES(RestartLaw);

class ContinueLaw : public test::TechniqueLaw {
 protected:
  static RunOptions options_of(const Framework& framework, const std::string& perturb) {
    RunOptions options{
        .technique = plain(),
        .resolve = {.max_sweeps = 25, .seed = 11, .walker = 3},
        .perturb_options = {.timestep = 0.02, .displacement = 0.5 * test::small_break(framework)},
        .every = 2};
    const auto last = static_cast<Joint>(framework.joint_count() - 1);
    if (perturb == "replay")
      options.replay = {{0, {20, 0, 0}}, {last, {0, 9, 0}}, {last, {0, 5, 5}}, {0, {1, 1, 1}},
                        {0, {0, 7, 0}},  {last, {3, 0, 3}}, {last, {0, 0, 4}}, {0, {2, 0, 0}}};
    else if (perturb == "guide")
      options.guide = test::guide_of(framework);
    else
      options.perturb = perturb;
    return options;
  }
};

/// In three parts: the end of the first is a frame that the whole run does not record, the end of
/// the second is one that it does. Some examples take a perturbation each; the law of
/// restarts takes all.
TEST_P(ContinueLaw, ThreePartsAreTheWhole) {
  const std::vector<std::string> perturbations{"force", "force_all", "displacement", "replay",
                                               "guide"};
  const TempDirectory directory;
  std::size_t count = 0;
  each_example([&](const Example& example) {
    if (example.framework.joint_count() == 0) return;
    if (count++ % 11 != 0 && std::getenv("PLIANT_ALL") == nullptr) return;
    const std::string& perturb = perturbations[count % perturbations.size()];
    SCOPED_TRACE(perturb);
    RunOptions options = options_of(example.framework, perturb);
    const H5mdOptions recording{.precision = perturb == "force_all" ? 0.01 : 0.0};
    const auto whole = directory / ("whole-" + std::to_string(count));
    const auto parts = directory / ("parts-" + std::to_string(count));
    const State start(example.positions);
    options.steps = 8;
    record_run(whole, example.framework, start, options, recording);
    options.steps = 3;
    record_run(parts, example.framework, start, options, recording);
    go_on(parts, 6);
    go_on(parts, 8);
    test::expect_same_file(whole, parts);
  });
}

PLIANT_FOR_ALL_TECHNIQUES(ContinueLaw);

}  // namespace pliant::restart_law_test
