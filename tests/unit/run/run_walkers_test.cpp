// SPDX-License-Identifier: MIT
#include "pliant/framework/measures/residual.hpp"
#include "pliant/lab/examples/examples.hpp"
#include "pliant/perturb/perturbation.hpp"
#include "pliant/run/run.hpp"
#include "support/frameworks.hpp"
#include "support/test.hpp"

namespace pliant::run_walkers_test {

struct Seen {
  std::vector<std::vector<Vec3>> frames;
  std::vector<double> rms_residuals;
  std::vector<std::int64_t> sweeps;
  RunSummary summary;

  Observer observer() {
    return [this](const Frame& frame) {
      frames.emplace_back(frame.positions.begin(), frame.positions.end());
      rms_residuals.push_back(frame.rms_residual);
      sweeps.push_back(frame.sweeps);
      return false;
    };
  }
};

RunOptions options_of(std::string_view perturbation, std::string_view technique) {
  return {.technique = {std::string(technique), 0.5},
          .resolve = {.max_sweeps = 60, .seed = 3},
          .perturb = std::string(perturbation),
          .steps = 25,
          .every = 4};
}

std::vector<Seen> run_alone(const Sketch& sketch, RunOptions options, std::uint64_t count) {
  std::vector<Seen> seen(count);
  const Framework framework = framework_of(sketch);
  for (std::uint64_t k = 0; k < count; ++k) {
    State state(sketch.positions);
    options.resolve.walker = k;
    seen[k].summary = run(framework, state, options, {seen[k].observer()});
  }
  return seen;
}

std::vector<Seen> run_together(const Sketch& sketch, const RunOptions& options,
                               std::uint64_t count) {
  std::vector<Seen> seen(count);
  const Framework framework = framework_of(sketch);
  std::vector<State> states(count, State(sketch.positions));
  std::vector<WalkerRun> walkers;
  for (std::uint64_t k = 0; k < count; ++k)
    walkers.push_back({states[k], k, {seen[k].observer()}, {}, {}});
  const auto summaries = run_walkers(framework, walkers, options);
  for (std::uint64_t k = 0; k < count; ++k) seen[k].summary = summaries[k];
  return seen;
}

void expect_same(const std::vector<Seen>& alone, const std::vector<Seen>& together) {
  for (std::size_t k = 0; k < alone.size(); ++k) {
    SCOPED_TRACE("walker " + std::to_string(k));
    ASSERT_EQ(together[k].frames.size(), alone[k].frames.size());
    for (std::size_t f = 0; f < alone[k].frames.size(); ++f)
      EXPECT_TRUE(test::same_bits(together[k].frames[f], alone[k].frames[f])) << "frame " << f;
    EXPECT_EQ(together[k].rms_residuals, alone[k].rms_residuals);
    EXPECT_EQ(together[k].sweeps, alone[k].sweeps);
    EXPECT_EQ(together[k].summary.projections, alone[k].summary.projections);
    EXPECT_EQ(together[k].summary.worst_residual, alone[k].summary.worst_residual);
    EXPECT_EQ(together[k].summary.worst_step, alone[k].summary.worst_step);
    EXPECT_EQ(together[k].summary.unconverged_steps, alone[k].summary.unconverged_steps);
  }
}

TEST(RunWalkers, DoTogetherWhatTheyDoAlone) {
  for (const Sketch& sketch : {chain(12), grid(3, 3), with_angles(shaken(chain(8), 0.25))})
    for (const PerturbationEntry& perturbation : perturbations())
      for (const char* technique :
           {"auto", "bfs_cycle", "bfs_reverse", "random", "blocks", "newton", "shake", "units"}) {
        SCOPED_TRACE(std::string(perturbation.name) + ", " + technique);
        const RunOptions options = options_of(perturbation.name, technique);
        expect_same(run_alone(sketch, options, 10), run_together(sketch, options, 10));
      }
}

TEST(RunWalkers, OneThatStopsLeavesTheOthersGoing) {
  const Sketch sketch = chain(12);
  const Framework framework = framework_of(sketch);
  const RunOptions options = options_of("displacement", "blocks");
  std::vector<State> states(3, State(sketch.positions));
  const Observer stops_at_8 = [](const Frame& frame) { return frame.step == 8; };
  std::vector<WalkerRun> walkers;
  for (std::uint64_t k = 0; k < 3; ++k) walkers.push_back({states[k], k});
  walkers[1].observers = {stops_at_8};
  const auto summaries = run_walkers(framework, walkers, options);
  EXPECT_EQ(summaries[0].steps, 25);
  EXPECT_EQ(summaries[1].steps, 8);
  EXPECT_TRUE(summaries[1].stopped_by_caller);
  EXPECT_EQ(summaries[2].steps, 25);
  EXPECT_FALSE(summaries[2].stopped_by_caller);
}

TEST(RunWalkers, APushBeyondNumbersIsTakenBackAlone) {
  const Sketch sketch = chain(12);
  RunOptions options = options_of("force_all", "blocks");
  options.perturb_options.force = 1e306;
  options.perturb_options.timestep = 1.0;
  const auto alone = run_alone(sketch, options, 9);
  expect_same(alone, run_together(sketch, options, 9));
  EXPECT_GT(alone[0].summary.unconverged_steps, 0);
}

TEST(RunWalkers, AnObserverThatThrowsLeavesTheOthersAtWholeSteps) {
  const Sketch sketch = chain(12);
  const Framework framework = framework_of(sketch);
  for (const char* technique : {"blocks", "random"}) {
    SCOPED_TRACE(technique);
    std::vector<State> states(3, State(sketch.positions));
    std::vector<WalkerRun> walkers;
    for (std::uint64_t k = 0; k < 3; ++k) walkers.push_back({states[k], k});
    walkers[1].observers = {[](const Frame& frame) -> bool {
      if (frame.step == 8) throw InputError("enough");
      return false;
    }};
    RunOptions options = options_of("displacement", technique);
    options.resolve.max_sweeps = 10000;
    EXPECT_THROW(run_walkers(framework, walkers, options), InputError);
    EXPECT_EQ(states[0].step, 8);
    EXPECT_EQ(states[1].step, 8);
    EXPECT_EQ(states[2].step, 7);
    for (const State& state : states)
      EXPECT_TRUE(measure(framework, state.positions, options.resolve.tolerance).within);
  }
}

TEST(RunWalkers, TimesAreNeverNegativeWhereSomeWereNotBegun) {
  const Sketch sketch = chain(12);
  const Framework framework = framework_of(sketch);
  EXPECT_TRUE(run_walkers(framework, {}, options_of("force", "blocks")).empty());
  for (int patience = 30; patience < 60; ++patience) {  // ends between groups, and elsewhere
    RunOptions options = options_of("displacement", "blocks");
    int asked = 0;
    options.resolve.should_stop = [&] { return ++asked > patience; };
    std::vector<State> states(20, State(sketch.positions));
    std::vector<WalkerRun> walkers;
    for (std::uint64_t k = 0; k < states.size(); ++k) walkers.push_back({states[k], k});
    for (const RunSummary& summary : run_walkers(framework, walkers, options)) {
      EXPECT_TRUE(summary.stopped_by_caller);
      EXPECT_GE(summary.seconds, 0.0);
      EXPECT_GE(summary.resolve_seconds, 0.0);
    }
  }
}

}  // namespace pliant::run_walkers_test
