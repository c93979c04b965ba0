// SPDX-License-Identifier: MIT
#include "pliant/run/ensemble.hpp"

#include <algorithm>
#include <atomic>
#include <deque>
#include <exception>
#include <string>

#include "pliant/base/error.hpp"
#include "pliant/base/threads/threads.hpp"
#include "pliant/resolve/lanes/lane_kernels.hpp"
#include "pliant/resolve/walkers.hpp"
#include "pliant/run/together.hpp"

namespace pliant {
namespace {

/// The first failure of several threads.
class FirstFailure {
 public:
  /// Keeps the exception that is being handled.
  void keep() {
    const std::lock_guard hold(mutex_);
    if (!first_) first_ = std::current_exception();
  }
  void rethrow() const {
    if (first_) std::rethrow_exception(first_);
  }

 private:
  Mutex mutex_;
  std::exception_ptr first_;
};

/// A walker and those who look at it.
struct Watched {
  std::uint64_t number;
  Watchers watchers;
  State state;
  FirstFailure& failure;
  bool has_failed = false;

  void guard(const auto& call) {
    try {
      call();
    } catch (...) {
      failure.keep();
      has_failed = true;
    }
  }

  bool show(const Frame& frame) {
    bool stops = false;
    guard([&] {
      for (const Observer& observer : watchers.observers)
        if (observer(frame)) stops = true;
    });
    return stops || has_failed;
  }

  void end(const RunSummary& summary) {
    if (watchers.on_end) guard([&] { watchers.on_end(summary, state); });
  }

  /// What run_walkers is given; this must stay where it is.
  WalkerRun run() {
    WalkerRun run{state, number};
    run.observers = {[this](const Frame& frame) { return show(frame); }};
    run.hands = watchers.hands;
    run.onlooker = watchers.onlooker;
    run.log = watchers.log;
    if (watchers.reached) run.began = watchers.reached->began;
    if (watchers.on_push)
      run.on_push = [this](const Push& push) { guard([&] { watchers.on_push(push); }); };
    return run;
  }
};

class Ensemble {
 public:
  Ensemble(const Framework& framework, const State& start, const EnsembleOptions& options,
           const WatchersOf& watchers_of)
      : framework_(framework),
        start_(start),
        options_(options),
        watchers_of_(watchers_of),
        summaries_(options.shard.size()),
        begun_(options.shard.size()) {}

  std::vector<RunSummary> run() {
    const auto threads = static_cast<std::uint64_t>(options_.threads);
    // As many as fit into the lanes, if that leaves no thread without.
    group_size_ = std::clamp<std::uint64_t>((count() + threads - 1) / threads, 1, lane_count);
    run_in_threads(std::min(threads, count()), [this](std::size_t) { run_next_groups(); });
    failure_.rethrow();
    for (std::size_t k = 0; k < summaries_.size(); ++k)
      if (!begun_[k]) summaries_[k].stopped_by_caller = true;
    return std::move(summaries_);
  }

 private:
  std::uint64_t count() const { return options_.shard.size(); }

  bool is_interrupted() const {
    return options_.run.resolve.should_stop && options_.run.resolve.should_stop();
  }

  void run_next_groups() {
    try {
      WalkerResolver resolver(framework_, options_.run.technique, options_.run.resolve,
                              options_.run.lanes);
      while (run_next_group(resolver)) continue;
    } catch (...) {
      failure_.keep();
    }
  }

  /// Walkers that no lanes can take go one after another: a step costs what its push reaches as
  /// long as the resolver knows the step before, but in turn with others all joints, which is 70
  /// times as much for a protein of 3341 atoms.
  bool run_next_group(WalkerResolver& resolver) {
    const std::uint64_t size = resolver.may_use_lanes() ? group_size_ : 1;
    const std::uint64_t begin = next_.fetch_add(size);
    if (begin >= count() || is_interrupted()) return false;
    return run_group(resolver, begin, std::min(begin + size, count()));
  }

  /// Walkers [begin, end) of the shard in step with each other; false if none could be begun.
  bool run_group(WalkerResolver& resolver, std::uint64_t begin, std::uint64_t end) {
    std::deque<Watched> group;  // which stay where they are
    for (std::uint64_t k = begin; k < end; ++k) watch(options_.shard.first + k, group);
    if (group.empty()) return false;
    std::vector<WalkerRun> runs;
    runs.reserve(group.size());
    for (Watched& walker : group) runs.push_back(walker.run());
    const auto summaries = Together(framework_, resolver, runs, options_.run).run();
    const std::lock_guard one_after_another(watchers_);
    for (std::size_t k = 0; k < group.size(); ++k) {
      summaries_[group[k].number - options_.shard.first] = summaries[k];
      begun_[group[k].number - options_.shard.first] = true;
      group[k].end(summaries[k]);
    }
    return true;
  }

  void watch(std::uint64_t walker, std::deque<Watched>& group) {
    const std::lock_guard one_after_another(watchers_);
    try {
      Watchers watchers = watchers_of_ ? watchers_of_(walker) : Watchers();
      State state = watchers.reached ? State(std::move(watchers.reached->state)) : start_;
      group.push_back({walker, std::move(watchers), std::move(state), failure_});
    } catch (...) {
      failure_.keep();
    }
  }

  const Framework& framework_;
  const State& start_;
  const EnsembleOptions& options_;
  const WatchersOf& watchers_of_;
  std::uint64_t group_size_ = 1;        ///< walkers that step together in lanes
  std::atomic<std::uint64_t> next_{0};  ///< of the shard, to be begun
  Mutex watchers_;
  FirstFailure failure_;
  std::vector<RunSummary> summaries_;
  std::vector<bool> begun_;  ///< of the shard
};

}  // namespace

void check(const EnsembleOptions& options) {
  check(options.run);
  if (options.threads < 1)
    throw OptionError("threads = " + std::to_string(options.threads) + ": must be from 1");
  if (options.shard.end < options.shard.first)
    throw OptionError("shard = [" + std::to_string(options.shard.first) + ", " +
                      std::to_string(options.shard.end) + "): must not end before it begins");
}

std::vector<RunSummary> run_ensemble(const Framework& framework, const State& start,
                                     const EnsembleOptions& options,
                                     const WatchersOf& watchers_of) {
  check(options);
  return Ensemble(framework, start, options, watchers_of).run();
}

}  // namespace pliant
