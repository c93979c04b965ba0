// SPDX-License-Identifier: MIT
#include "pliant/run/ensemble.hpp"

#include <mutex>

#include "pliant/lab/examples/examples.hpp"
#include "support/frameworks.hpp"
#include "support/test.hpp"

namespace pliant::ensemble_test {

using Hashes = std::map<std::uint64_t, std::uint64_t>;

EnsembleOptions options_of(Shard shard, int threads, const char* technique = "auto",
                           const char* perturb = "displacement") {
  return {.run = {.technique = {.name = technique}, .perturb = perturb, .steps = 12, .every = 5},
          .shard = shard,
          .threads = threads};
}

/// All frames of each walker, as one number.
void watch_shard(const Framework& framework, const State& start, const EnsembleOptions& options,
                 Hashes& hashes) {
  std::mutex mutex;
  const auto summaries = run_ensemble(framework, start, options, [&](std::uint64_t walker) {
    return std::vector<Observer>{[&, walker](const Frame& frame) {
      const std::lock_guard hold(mutex);
      hashes[walker] = test::hash_of(frame.positions, hashes[walker]);
      return false;
    }};
  });
  EXPECT_EQ(summaries.size(), options.shard.size());
  for (const RunSummary& summary : summaries) EXPECT_EQ(summary.steps, 12);
}

TEST(Ensemble, AShardInTwoHalvesIsTheWhole) {
  const Sketch sketch = chain(12);
  const Framework framework = framework_of(sketch);
  const State start(sketch.positions);
  for (const char* technique : {"auto", "bfs_cycle", "random", "shake"})
    for (const char* perturb : {"force", "displacement"}) {
      SCOPED_TRACE(std::string(technique) + ", " + perturb);
      Hashes whole, halves;
      watch_shard(framework, start, options_of({3, 22}, 1, technique, perturb), whole);
      watch_shard(framework, start, options_of({3, 10}, 2, technique, perturb), halves);
      watch_shard(framework, start, options_of({10, 22}, 3, technique, perturb), halves);
      EXPECT_EQ(whole, halves);
      EXPECT_EQ(whole.size(), 19u);
    }
}

/// A chain of twelve, two joints of which a limit ties.
Framework tied() {
  const Sketch sketch = chain(12);
  FrameworkParts parts = framework_of(sketch).parts();
  const double length = distance(sketch.positions[2], sketch.positions[9]);
  parts.limits = {{2, 9, 0.0, length + 1.0, LimitKind::hydrogen_bond, 0.0, 4}};
  return Framework(parts);
}

/// The walkers whose frames come, in this order, each named once until another's come.
std::vector<std::uint64_t> turns_of(const Framework& framework, const State& start) {
  std::vector<std::uint64_t> turns;
  run_ensemble(framework, start, options_of({0, 3}, 1), [&](std::uint64_t walker) {
    return std::vector<Observer>{[&turns, walker](const Frame& frame) {
      if (frame.step > 0 && (turns.empty() || turns.back() != walker)) turns.push_back(walker);
      return false;
    }};
  });
  return turns;
}

TEST(Ensemble, WalkersThatLanesCannotTakeGoOneAfterAnother) {
  const State start(chain(12).positions);
  EXPECT_GT(turns_of(framework_of(chain(12)), start).size(), 3u);
  EXPECT_EQ(turns_of(tied(), start), (std::vector<std::uint64_t>{0, 1, 2}));
}

TEST(Ensemble, AWalkerDoesWhatARunOfItDoes) {
  const State start(chain(12).positions);
  for (const Framework& framework : {framework_of(chain(12)), tied()})
    for (const char* perturb : {"force", "displacement"}) {
      SCOPED_TRACE(perturb);
      EnsembleOptions options = options_of({5, 9}, 2, "auto", perturb);
      Hashes shard, alone;
      watch_shard(framework, start, options, shard);
      for (std::uint64_t walker = 5; walker < 9; ++walker) {
        options.run.resolve.walker = walker;
        State state = start;
        run(framework, state, options.run, {[&](const Frame& frame) {
              alone[walker] = test::hash_of(frame.positions, alone[walker]);
              return false;
            }});
      }
      EXPECT_EQ(shard, alone);
    }
}

/// Those before it are over and told; it stops at its frame; those after it go on.
TEST(Ensemble, WithLimitsOneThatFailsLeavesTheOthersTheirs) {
  std::map<std::uint64_t, std::int64_t> ended;
  const auto watchers_of = [&](std::uint64_t walker) {
    Watchers watchers;
    watchers.observers = {[walker](const Frame& frame) {
      if (walker == 1 && frame.step == 5) throw InputError("broken");
      return false;
    }};
    watchers.on_end = [&ended, walker](const RunSummary&, const State& state) {
      ended[walker] = state.step;
    };
    return watchers;
  };
  const State start(chain(12).positions);
  EXPECT_THROW(run_ensemble(tied(), start, options_of({0, 3}, 1), watchers_of), InputError);
  EXPECT_EQ(ended, (std::map<std::uint64_t, std::int64_t>{{0, 12}, {1, 5}, {2, 12}}));
}

TEST(Ensemble, OneThatFailsStopsAloneAndIsTold) {
  const Sketch sketch = chain(12);
  const Framework framework = framework_of(sketch);
  std::vector<std::int64_t> steps(20);
  EXPECT_THROW(run_ensemble(framework, State(sketch.positions), options_of({0, 20}, 2),
                            [&](std::uint64_t walker) {
                              if (walker == 5) throw FileError("no room");
                              Watchers watchers(std::vector<Observer>{[walker](const Frame& frame) {
                                if (walker == 7 && frame.step == 5) throw FileError("full");
                                return false;
                              }});
                              watchers.on_end = [&steps, walker](const RunSummary& summary,
                                                                 const State&) {
                                steps[walker] = summary.steps;
                              };
                              return watchers;
                            }),
               FileError);
  for (std::size_t walker = 0; walker < 20; ++walker)
    EXPECT_EQ(steps[walker], walker == 5 ? 0 : walker == 7 ? 5 : 12) << walker;
}

TEST(Ensemble, TellsWhichWalkersWereNotBegun) {
  const Sketch sketch = chain(12);
  EnsembleOptions options = options_of({0, 20}, 1);
  bool stops = false;
  options.run.resolve.should_stop = [&] { return stops; };
  const auto summaries =
      run_ensemble(framework_of(sketch), State(sketch.positions), options, [&](std::uint64_t) {
        return std::vector<Observer>{[&](const Frame& frame) { return stops = frame.step == 10; }};
      });
  for (std::size_t walker = 0; walker < 20; ++walker) {
    EXPECT_TRUE(summaries[walker].stopped_by_caller);
    EXPECT_EQ(summaries[walker].frames > 0, walker < 8);
  }
}

TEST(Ensemble, NeedsNoWatchersAndNoWalkers) {
  const Framework framework = framework_of(chain(3));
  const State start(chain(3).positions);
  EXPECT_EQ(run_ensemble(framework, start, options_of({0, 2}, 4))[1].steps, 12);
  EXPECT_TRUE(run_ensemble(framework, start, options_of({7, 7}, 1)).empty());
}

TEST(Ensemble, RefusesWhatCannotBe) {
  const Framework framework = framework_of(chain(3));
  const State start(chain(3).positions);
  EXPECT_ERROR(OptionError, "threads = 0: must be from 1",
               run_ensemble(framework, start, options_of({0, 1}, 0)));
  EXPECT_ERROR(OptionError, "shard = [5, 3): must not end before it begins",
               run_ensemble(framework, start, options_of({5, 3}, 1)));
}

}  // namespace pliant::ensemble_test
