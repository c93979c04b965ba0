// SPDX-License-Identifier: MIT
// Ensemble: many walkers of one framework, on threads and in SIMD lanes.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "pliant/run/run.hpp"

namespace pliant {

/// Walkers [first, end). The result of a walker depends on its number, not on the shard: shards may
/// run on different machines and together give the bits of one run.
struct Shard {
  std::uint64_t first = 0, end = 1;

  std::uint64_t size() const { return end - first; }
};

/// Options of an ensemble. Checked once, at its start.
struct EnsembleOptions {
  RunOptions run = {};  ///< of each walker; its resolve.walker, on_push and log are ignored
  Shard shard = {};
  /// From 1. Changes no result. Up to eight walkers step together on each where lanes can take them
  /// (bars alone, by a technique that has lanes); elsewhere one walker follows the other.
  int threads = 1;
};

/// Throws OptionError naming the option, its value and its range.
void check(const EnsembleOptions& options);

/// The state from which a walker continues that began in an earlier run.
struct WalkerReached {
  State state;
  std::int64_t began = 0;  ///< as RunOptions::began
};

/// Observers of one walker. An exception stops only this walker, at its next frame.
struct Watchers {
  std::vector<Observer> observers = {};
  std::function<void(const Push&)> on_push = {};
  std::vector<std::shared_ptr<Pusher>> hands = {};  ///< as RunOptions::hands
  Onlooker onlooker = {};
  /// Called once with the summary and the last state of a walker that was begun.
  std::function<void(const RunSummary&, const State&)> on_end = {};
  Log log = {};
  std::optional<WalkerReached> reached = {};  ///< replaces the common start

  Watchers() = default;
  Watchers(std::vector<Observer> them) : observers(std::move(them)) {}
};

/// Makes the watchers of a walker before it begins; if it throws, the walker is not begun.
using WatchersOf = std::function<Watchers(std::uint64_t walker)>;

/// Runs each walker from a copy of `start`, as run() does, and returns their summaries in the order
/// of their numbers; one that was not begun has no frames and is stopped_by_caller. Watchers of
/// different walkers are called from several threads at once, but `watchers_of` and on_end one
/// after another. Throws as run(), or the first exception of a watcher, after all walkers have
/// ended.
std::vector<RunSummary> run_ensemble(const Framework& framework, const State& start,
                                     const EnsembleOptions& options,
                                     const WatchersOf& watchers_of = {});

}  // namespace pliant
