// SPDX-License-Identifier: MIT
// Who looks at runs from Python.
#pragma once

#include <atomic>
#include <mutex>
#include <thread>
#include <vector>

#include "interrupt.hpp"
#include "pliant/jobs/job.hpp"
#include "pliant/jobs/run_watch.hpp"
#include "run/observers.hpp"

namespace pliant::python {

/// A State that a run moves; no other run may move it meanwhile. Made and ended with the GIL held.
class StateInUse {
 public:
  explicit StateInUse(const State& state);
  ~StateInUse();
  StateInUse(const StateInUse&) = delete;
  StateInUse& operator=(const StateInUse&) = delete;

 private:
  const State* state_;
};

/// Looks at a single walker, whose frames show the State that it moves. Made and ended with the GIL
/// held.
class AloneWatched {
 public:
  /// Frames that take at most so many bytes in all are kept.
  AloneWatched(const Framework& framework, nb::handle state, const RunOptions& options,
               std::vector<nb::object> observers, std::int64_t most_kept);

  RunWatch watch();
  /// What later runs go on from. Needs no GIL.
  void end(const State& state);
  /// Raises what a handler of Ctrl-C raised.
  OwnedRunSummary summary(const RunSummary& summary, nb::object state);

 private:
  std::vector<Observer> observers();

  nb::handle state_;
  std::vector<nb::object> observers_;
  std::vector<LockedRecorder*> recorders_;
  InterruptWatch interrupt_;
  std::int64_t done_;
  bool keeps_;
  std::vector<Vec3> kept_;
};

/// Looks at walkers that are run on threads: frames hold copies of positions. Made and ended with
/// the GIL held.
class AllWatched {
 public:
  /// `observers_of` is called with a walker's number before it begins; None: nobody looks.
  AllWatched(nb::object observers_of, const Job& job);

  RunWatch watch();
  /// In the order of the walkers. Raises what a handler of Ctrl-C raised.
  std::vector<OwnedRunSummary> summaries(const std::vector<RunSummary>& summaries) const;

 private:
  std::vector<Observer> begin(std::int64_t walker);
  void end(std::int64_t walker, const State& last);

  nb::object observers_of_;
  std::int64_t first_;
  std::thread::id caller_ = std::this_thread::get_id();
  InterruptWatch interrupt_;
  std::atomic<std::int64_t> begun_{0};
  std::atomic<bool> stops_{false};
  std::vector<std::vector<nb::object>> observers_;  ///< by walker, until all have ended
  std::vector<nb::object> states_;                  ///< by walker
};

}  // namespace pliant::python
