// SPDX-License-Identifier: MIT
#include "pliant/jobs/continued_run.hpp"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <utility>

#include "pliant/base/error.hpp"
#include "pliant/base/system/descriptor.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/base/version.hpp"
#include "pliant/jobs/files/run_checkpoint.hpp"
#include "pliant/jobs/run_outputs.hpp"
#include "pliant/record/h5md/h5md_reader.hpp"

namespace pliant {
namespace {

namespace fs = std::filesystem;

/// The settings are those of the first walker that was begun.
std::string first_begun(const Job& job) {
  const std::int64_t end = job.walkers.first + job.walkers.walkers;
  for (std::int64_t walker = job.walkers.first; walker < end; ++walker)
    if (is_there(path_of(output_of(job, walker)))) return output_of(job, walker);
  const std::string name = output_of(job, job.walkers.first);
  if (job.walkers.are_several())
    throw FileError(name + ": none of the files of these walkers is there");
  const fs::path path = path_of(name);
  const std::string of_walkers = path_text(
      path.parent_path() / path_of(path_text(path.stem()) + "-0" + path_text(path.extension())));
  throw FileError(not_there(name) +
                  (is_there(path_of(of_walkers))
                       ? ", but " + of_walkers + " is: give --walkers as in the run"
                       : ""));
}

H5mdCheckpoint read_run(const std::string& file, std::optional<std::int64_t> steps,
                        std::string_view dashes, const Log& log) {
  H5mdCheckpoint from = read_checkpoint(path_of(file), steps, log);
  const std::string name = path_text(from.path);
  if (from.is_sample())
    throw InputError(name +
                     ": holds frames of a sample: pliant sample --continue and continue_sample go "
                     "on with them");
  if (from.done > from.steps)
    throw OptionError(option_name("steps", dashes) + (dashes.empty() ? " = " : " ") +
                      std::to_string(from.steps) + ": " + name + " has " +
                      std::to_string(from.done) +
                      " steps already; steps are counted from the start of the run");
  return from;
}

/// How the file of a walker is written that was begun; of the job what does not change its frames.
H5mdOptions recorded_like(const H5mdCheckpoint& from, H5mdOptions options) {
  for (const auto& [path, value] : from.parameters)
    if (path == "record/precision" && std::holds_alternative<double>(value))
      options.precision = std::get<double>(value);
  return options;
}

}  // namespace

ContinuedRun::ContinuedRun(Job job, std::optional<std::int64_t> steps, std::string_view dashes,
                           const Log& log)
    : job_(std::move(job)), steps_(steps), log_(log) {
  job_.output.output = job_.go_on;
  job_.output.topology = no_topology;
  job_.output.record.log = log;
  from_ = read_run(first_begun(job_), steps, dashes, log);
  job_.run = run_options_from(from_);
  // The file of one walker of several goes on as that walker.
  if (!job_.walkers.are_several())
    job_.walkers.first = static_cast<std::int64_t>(job_.run.resolve.walker);
  frames_added_.resize(static_cast<std::size_t>(job_.walkers.walkers));
}

std::vector<RunSummary> ContinuedRun::run(const RunWatch& watch) {
  if (from_.last_step >= from_.began + from_.steps)
    log_.note(path_text(from_.path) + " has all of its " + std::to_string(from_.steps) +
              " steps; --steps N goes on up to step N");
  std::vector<RunSummary> summaries = run_ensemble(
      from_.framework, State(start()), ensemble_of(job_, watch),
      [&](std::uint64_t walker) { return watchers_of(static_cast<std::int64_t>(walker), watch); });
  for (std::size_t k = 0; k < summaries.size(); ++k) summaries[k].frames = frames_added_[k];
  return summaries;
}

/// Where walkers that have not begun will start.
std::vector<Vec3> ContinuedRun::start() const {
  return from_.inputs.start.empty() ? from_.state.positions : from_.inputs.start;
}

Watchers ContinuedRun::watchers_of(std::int64_t walker, const RunWatch& watch) {
  const std::string file = output_of(job_, walker);
  Watchers watchers;
  if (walker == job_.walkers.first) watchers.log = log_;
  if (!is_there(path_of(file))) {
    record(watchers, walker, begin(file, walker), 0, watch);
    return watchers;
  }
  H5mdCheckpoint from = read_checkpoint(path_of(file), steps_, log_);
  check_same_run(from, walker);
  const std::int64_t last_step = from.began + from.steps;
  if (from.last_step >= last_step) {
    from.state.step = last_step;  // there is nothing more to do
    watchers.on_end = [walker, &watch](const RunSummary&, const State& state) {
      if (watch.on_end) watch.on_end(walker, state);
    };
  } else {
    record(watchers, walker, std::make_shared<H5mdRecorder>(from, job_.output.record), from.frames,
           watch);
  }
  watchers.reached = {std::move(from.state), from.began};
  return watchers;
}

void ContinuedRun::record(Watchers& watchers, std::int64_t walker,
                          std::shared_ptr<H5mdRecorder> recorder, std::int64_t frames_before,
                          const RunWatch& watch) {
  watchers.observers = {[this, recorder, &watch](const Frame& frame) {
    recorder->record(frame);
    if (watch.on_steps) {
      const std::lock_guard hold(counting_);
      watch.on_steps(++frames_shown_);
    }
    return watch.stops();
  }};
  if (watch.observers_of)
    for (Observer& other : watch.observers_of(walker))
      watchers.observers.push_back(std::move(other));
  watchers.on_end = [this, walker, recorder, frames_before, &watch](const RunSummary&,
                                                                    const State& state) {
    if (watch.on_end) watch.on_end(walker, state);
    recorder->end_run(state);
    recorder->close();
    frames_added_[static_cast<std::size_t>(walker - job_.walkers.first)] =
        recorder->frames() - frames_before;
  };
}

/// A walker of the run that was never begun. Its file says what the others say.
std::shared_ptr<H5mdRecorder> ContinuedRun::begin(const std::string& file,
                                                  std::int64_t walker) const {
  if (from_.inputs.start.empty())
    throw FileError(file + ": is not there, and " + path_text(from_.path) +
                    " does not say where walkers start");
  const H5mdReader reader(from_.path);
  H5mdHeader header;
  header.bonds = reader.bonds();
  header.bond_origin_names = reader.bond_origin_names();
  header.masses = reader.masses();
  header.creator_version = std::string(version());
  header.parameters = from_.parameters;
  for (auto& [path, value] : header.parameters) {
    if (path == "run/walker") value = walker;
    if (path == "run/steps") value = job_.run.steps;
  }
  header.inputs = from_.inputs;
  return std::make_shared<H5mdRecorder>(path_of(file), from_.framework, header,
                                        recorded_like(from_, job_.output.record));
}

void ContinuedRun::check_same_run(const H5mdCheckpoint& other, std::int64_t walker) const {
  const auto refuse = [&](const std::string& what) {
    throw InputError(path_text(other.path) + ": is of another run than " + path_text(from_.path) +
                     ": " + what + " differs");
  };
  const Framework &a = from_.framework, &b = other.framework;
  if (!std::ranges::equal(a.bars(), b.bars()) ||
      !std::ranges::equal(a.rest_lengths(), b.rest_lengths()))
    refuse("the framework");
  if (other.parameters.size() != from_.parameters.size()) refuse("what its parameters are");
  for (std::size_t k = 0; k < other.parameters.size(); ++k) {
    const auto& [path, value] = other.parameters[k];
    if (path == "run/steps") continue;
    const Parameter expected = path == "run/walker" && job_.walkers.are_several()
                                   ? Parameter(walker)
                                   : from_.parameters[k].second;
    if (path != from_.parameters[k].first || value != expected) refuse("/parameters/" + path);
  }
}

}  // namespace pliant
