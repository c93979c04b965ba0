// SPDX-License-Identifier: MIT
#include "run/run_watched.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

namespace pliant::python {
namespace {

std::set<const State*>& states_in_use() {
  static std::set<const State*> states;
  return states;
}

/// Whether all frames of a run take no more than so many bytes.
bool are_kept(const Framework& framework, const RunOptions& options, std::int64_t most) {
  const auto bytes = static_cast<std::int64_t>(framework.joint_count() * sizeof(Vec3));
  const std::int64_t frames = options.steps / std::max<std::int64_t>(options.every, 1) + 2;
  return bytes > 0 && frames <= most / bytes;
}

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

}  // namespace

StateInUse::StateInUse(const State& state) : state_(&state) {
  if (!states_in_use().insert(state_).second)
    throw std::runtime_error("State: another run is moving it");
}

StateInUse::~StateInUse() { states_in_use().erase(state_); }

AloneWatched::AloneWatched(const Framework& framework, nb::handle state, const RunOptions& options,
                           std::vector<nb::object> observers, std::int64_t most_kept)
    : state_(state),
      observers_(std::move(observers)),
      interrupt_("steps", options.steps),
      done_(options.began.value_or(0)),
      keeps_(are_kept(framework, options, most_kept)) {
  for (const nb::object& observer : observers_)
    if (nb::isinstance<LockedRecorder>(observer))
      recorders_.push_back(&nb::cast<LockedRecorder&>(observer));
}

std::vector<Observer> AloneWatched::observers() {
  std::vector<Observer> all;
  for (const nb::object& observer : observers_) all.push_back(observer_of(observer, state_));
  all.push_back([this](const Frame& frame) {
    if (keeps_) kept_.insert(kept_.end(), frame.positions.begin(), frame.positions.end());
    return interrupt_(done_);
  });
  return all;
}

RunWatch AloneWatched::watch() {
  RunWatch watch;
  watch.observers_of = [all = observers()](std::int64_t) { return all; };
  watch.should_stop = [this] { return interrupt_(done_); };
  watch.onlooker.wants = [this](std::int64_t step) {
    done_ = step;
    return false;
  };
  return watch;
}

void AloneWatched::end(const State& state) {
  for (LockedRecorder* shared : recorders_)
    shared->use([&](H5mdRecorder& recorder) { recorder.end_run(state); });
}

OwnedRunSummary AloneWatched::summary(const RunSummary& summary, nb::object state) {
  if (interrupt_.raised()) std::rethrow_exception(interrupt_.raised());
  return {summary, std::move(state), std::move(kept_)};
}

AllWatched::AllWatched(nb::object observers_of, const Job& job)
    : observers_of_(std::move(observers_of)),
      first_(job.walkers.first),
      interrupt_(job.walkers.are_several() ? InterruptWatch("walkers begun", job.walkers.walkers)
                                           : InterruptWatch()),
      observers_(static_cast<std::size_t>(job.walkers.walkers)),
      states_(static_cast<std::size_t>(job.walkers.walkers), nb::none()) {}

RunWatch AllWatched::watch() {
  RunWatch watch;
  // Signals are handled in the thread that called.
  watch.should_stop = [this] {
    if (std::this_thread::get_id() == caller_ && interrupt_(begun_)) stops_ = true;
    return stops_.load();
  };
  watch.observers_of = [this](std::int64_t walker) { return begin(walker); };
  watch.on_end = [this](std::int64_t walker, const State& last) { end(walker, last); };
  return watch;
}

std::vector<Observer> AllWatched::begin(std::int64_t walker) {
  ++begun_;
  const nb::gil_scoped_acquire gil;
  std::vector<nb::object>& mine = observers_[static_cast<std::size_t>(walker - first_)];
  if (!observers_of_.is_none())
    for (nb::handle observer : nb::borrow<nb::object>(observers_of_(walker)))
      mine.push_back(nb::borrow(observer));
  std::vector<Observer> all;
  for (const nb::object& observer : mine) all.push_back(copying_observer(observer));
  return all;
}

void AllWatched::end(std::int64_t walker, const State& last) {
  const nb::gil_scoped_acquire gil;
  const auto k = static_cast<std::size_t>(walker - first_);
  states_[k] = nb::cast(State(last));
  for (const nb::object& observer : observers_[k])
    if (nb::isinstance<LockedRecorder>(observer)) observer.attr("close")();
}

std::vector<OwnedRunSummary> AllWatched::summaries(const std::vector<RunSummary>& summaries) const {
  if (interrupt_.raised()) std::rethrow_exception(interrupt_.raised());
  std::vector<OwnedRunSummary> owned;
  for (std::size_t k = 0; k < summaries.size(); ++k) owned.push_back({summaries[k], states_[k]});
  return owned;
}

}  // namespace pliant::python
