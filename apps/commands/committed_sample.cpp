// SPDX-License-Identifier: MIT
#include "commands/committed_sample.hpp"

#include "interrupt.hpp"
#include "pliant/base/system/path_text.hpp"

namespace pliant::app {
namespace {

/// A sample has no walkers.
constexpr std::int64_t only_walker = 0;

}  // namespace

CommittedSample::CommittedSample(const SampleSettings& settings, const SampleTask& task,
                                 std::span<const NamedParameter> parameters)
    : task_(task),
      log_(path_of(settings.commits.file), key_of_run(task.framework(), task.start(), parameters),
           settings.record.log),
      clock_(settings.commits.seconds),
      next_frame_(task.options().first_frame) {}

SampleSummary CommittedSample::run(const SampleObserver& observer) {
  if (const auto found = log_.committed(only_walker)) {
    frames_ = found->frames;
    next_frame_ = found->state.step + 1;
    log_.replay(only_walker, observer);
  }
  SampleSummary summary;
  if (interrupted()) {
    summary.stopped_by_caller = true;
  } else if (next_frame_ < task_.options().first_frame + task_.options().frames) {
    summary = make(next_frame_, observer);
  }
  if (summary.stopped_by_caller) commit();
  return summary;
}

SampleSummary CommittedSample::make(std::int64_t first, const SampleObserver& observer) {
  SampleOptions options = task_.options();
  options.frames -= first - options.first_frame;
  options.first_frame = first;
  options.should_stop = interrupted;
  return sample(task_.framework(), task_.start(), task_.nodes(), options,
                [&](const Frame& frame) { return see(frame, observer); });
}

bool CommittedSample::see(const Frame& frame, const SampleObserver& observer) {
  kept_.add(frame);
  next_frame_ = frame.step + 1;
  if (clock_.is_due()) commit();
  return observer(frame);
}

void CommittedSample::commit() {
  if (kept_.size() == 0) return;
  State state;
  state.step = next_frame_ - 1;
  // A log counts the frames of all commits.
  log_.commit(only_walker, kept_, 0, state, false, frames_);
  frames_ += kept_.size();
  kept_ = {};
  clock_.restart();
}

void CommittedSample::end() {
  if (!interrupted()) log_.remove();
}

}  // namespace pliant::app
