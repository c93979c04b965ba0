// SPDX-License-Identifier: MIT
// Ensembles: many walkers on threads, with observers made in Python.
#include "pliant/run/ensemble.hpp"

#include <nanobind/stl/pair.h>

#include <atomic>
#include <thread>

#include "interrupt.hpp"
#include "messages.hpp"
#include "resolve/techniques.hpp"
#include "run/observers.hpp"
#include "run/pushes.hpp"

namespace pliant::python {
namespace {

/// Frames belong to nobody in Python: the observer is given a copy of the positions of each.
Observer copying_observer(nb::handle object) {
  if (nb::isinstance<LockedRecorder>(object)) return recorder_observer(object);
  return [object](const Frame& frame) {
    const nb::gil_scoped_acquire gil;
    nb::object copy =
        nb::cast(State(std::vector<Vec3>(frame.positions.begin(), frame.positions.end())));
    Frame own = frame;
    own.positions = nb::cast<const State&>(copy).positions;
    return is_true(object(OwnedFrame{own, std::move(copy)}));
  };
}

/// Observers of all walkers and the states that they end in. Needs the GIL to be made and ended.
class Audience {
 public:
  Audience(nb::object observers_of, std::uint64_t first, std::uint64_t count)
      : observers_of_(std::move(observers_of)), first_(first), states_(count) {}

  /// Takes the GIL.
  Watchers watchers_of(std::uint64_t walker) {
    const nb::gil_scoped_acquire gil;
    Watchers watchers;
    watchers.log = python_log();
    std::vector<nb::object> observers;
    if (!observers_of_.is_none())
      for (nb::handle observer : nb::borrow<nb::object>(observers_of_(walker)))
        observers.push_back(nb::borrow(observer));
    for (const nb::object& observer : observers)
      watchers.observers.push_back(copying_observer(observer));
    kept_.insert(kept_.end(), observers.begin(), observers.end());
    watchers.on_end = [this, walker, recorders = recorders_of(observers)](const RunSummary&,
                                                                          const State& state) {
      const nb::gil_scoped_acquire gil_at_end;
      states_[walker - first_] = nb::cast(State(state));
      for (nb::handle recorder : recorders) recorder.attr("close")();
    };
    return watchers;
  }

  nb::object state_of(std::size_t k) const { return states_[k] ? states_[k] : nb::none(); }

 private:
  static std::vector<nb::handle> recorders_of(const std::vector<nb::object>& observers) {
    std::vector<nb::handle> recorders;
    for (const nb::object& observer : observers)
      if (nb::isinstance<LockedRecorder>(observer)) recorders.push_back(observer);
    return recorders;
  }

  nb::object observers_of_;
  std::uint64_t first_;
  std::vector<nb::object> kept_;  ///< until all walkers have ended
  std::vector<nb::object> states_;
};

std::vector<OwnedRunSummary> run_shard(const Framework& framework, const State& start,
                                       RunOptions run,
                                       std::pair<std::uint64_t, std::uint64_t> shard, int threads,
                                       nb::object observers_of) {
  check_pushes(framework, run.replay);
  show_framework(run.technique, framework);
  EnsembleOptions options{std::move(run), {shard.first, shard.second}, threads};
  check(options);
  Audience audience(std::move(observers_of), shard.first, options.shard.size());
  InterruptWatch watch;
  std::atomic<bool> stops{false};
  // Signals are handled in the thread that called.
  options.run.resolve.should_stop = [&, caller = std::this_thread::get_id()] {
    if (std::this_thread::get_id() == caller && watch()) stops = true;
    return stops.load();
  };
  std::vector<RunSummary> summaries;
  const State own = start;
  {
    const nb::gil_scoped_release no_gil;
    summaries = run_ensemble(framework, own, options,
                             [&](std::uint64_t walker) { return audience.watchers_of(walker); });
  }
  if (watch.raised()) std::rethrow_exception(watch.raised());
  std::vector<OwnedRunSummary> owned;
  for (std::size_t k = 0; k < summaries.size(); ++k)
    owned.push_back({summaries[k], audience.state_of(k)});
  return owned;
}

}  // namespace

void bind_ensemble(nb::module_& module) {
  module.def("run_shard", &run_shard, "framework"_a, "state"_a, "options"_a, "shard"_a, "threads"_a,
             "observers_of"_a.none(), "The function ``run_ensemble`` says more.");
}

}  // namespace pliant::python
