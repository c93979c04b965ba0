// SPDX-License-Identifier: MIT
#include "commands/continue_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <mutex>
#include <thread>

#include "command.hpp"
#include "interrupt.hpp"
#include "messages.hpp"
#include "options/job_options.hpp"
#include "output/print_run.hpp"
#include "pliant/base/error.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/base/version.hpp"
#include "pliant/jobs/asked/output_options.hpp"
#include "pliant/jobs/files/recorded_run.hpp"
#include "pliant/record/h5md/h5md_reader.hpp"
#include "pliant/record/h5md/h5md_recorder.hpp"
#include "pliant/run/ensemble.hpp"

namespace pliant::app {
namespace {

namespace fs = std::filesystem;

bool is_there(const std::string& file) {
  std::error_code error;
  return fs::exists(path_of(file), error);
}

/// The settings are those of the first walker that was begun.
std::int64_t first_begun(const RunSettings& settings) {
  const std::int64_t end = settings.job.walkers.first + settings.job.walkers.walkers;
  for (std::int64_t walker = settings.job.walkers.first; walker < end; ++walker)
    if (is_there(output_of(settings, walker))) return walker;
  const std::string name = output_of(settings, settings.job.walkers.first);
  if (settings.job.walkers.are_several())
    throw FileError(name + ": none of the files of these walkers is there");
  const fs::path path = path_of(name);
  const std::string of_walkers = path_text(
      path.parent_path() / path_of(path_text(path.stem()) + "-0" + path_text(path.extension())));
  throw FileError(not_there(name) +
                  (is_there(of_walkers)
                       ? ", but " + of_walkers + " is: give --walkers or --shard as in the run"
                       : ""));
}

class ContinuedRun {
 public:
  ContinuedRun(const RunSettings& settings, std::optional<std::int64_t> steps,
               H5mdCheckpoint pattern, const Log& log, ProgressBar& progress)
      : settings_(settings),
        steps_(steps),
        pattern_(std::move(pattern)),
        options_(run_options_from(pattern_)),
        log_(log),
        progress_(progress),
        frames_added_(static_cast<std::size_t>(settings.job.walkers.walkers)) {}

  std::vector<RunSummary> run() {
    const auto first = static_cast<std::uint64_t>(settings_.job.walkers.first);
    EnsembleOptions options{
        options_,
        {first, first + static_cast<std::uint64_t>(settings_.job.walkers.walkers)},
        static_cast<int>(settings_.job.walkers.threads)};
    options.run.resolve.should_stop = interrupted;
    std::vector<RunSummary> summaries = run_ensemble(
        pattern_.framework, State(start()), options,
        [&](std::uint64_t walker) { return watchers_of(static_cast<std::int64_t>(walker)); });
    for (std::size_t k = 0; k < summaries.size(); ++k) summaries[k].frames = frames_added_[k];
    return summaries;
  }

  const RunOptions& options() const { return options_; }

 private:
  /// Where walkers that have not begun will start.
  std::vector<Vec3> start() const {
    return pattern_.inputs.start.empty() ? pattern_.state.positions : pattern_.inputs.start;
  }

  Watchers watchers_of(std::int64_t walker) {
    const std::string file = output_of(settings_, walker);
    Watchers watchers;
    if (walker == settings_.job.walkers.first) watchers.log = log_;
    if (!is_there(file)) {
      watch(watchers, walker, begin(file, walker), 0);
      return watchers;
    }
    H5mdCheckpoint from = read_checkpoint(path_of(file), steps_, log_);
    check_same_run(from, walker);
    const std::int64_t last_step = from.began + from.steps;
    if (from.last_step >= last_step) {
      from.state.step = last_step;  // there is nothing more to do
    } else {
      watch(watchers, walker, std::make_shared<H5mdRecorder>(from, record_options()), from.frames);
    }
    watchers.reached = {std::move(from.state), from.began};
    return watchers;
  }

  H5mdOptions record_options() const {
    H5mdOptions options = settings_.job.output.record;
    options.log = log_;
    return options;
  }

  void watch(Watchers& watchers, std::int64_t walker, const std::shared_ptr<H5mdRecorder>& recorder,
             std::int64_t frames_before) {
    std::int64_t& added =
        frames_added_[static_cast<std::size_t>(walker - settings_.job.walkers.first)];
    watchers.observers = {[this, recorder](const Frame& frame) {
      recorder->record(frame);
      show_progress();
      return interrupted();
    }};
    watchers.on_end = [recorder, frames_before, &added](const RunSummary&, const State& state) {
      recorder->end_run(state);
      recorder->close();
      added = recorder->frames() - frames_before;
    };
  }

  void show_progress() {
    const std::lock_guard hold(showing_);
    progress_.show(++frames_shown_);
  }

  /// A walker of the run that was never begun. Its file says what the others say.
  std::shared_ptr<H5mdRecorder> begin(const std::string& file, std::int64_t walker) const {
    if (pattern_.inputs.start.empty())
      throw FileError(file + ": is not there, and " + path_text(pattern_.path) +
                      " does not say where walkers start");
    const H5mdReader reader(pattern_.path);
    H5mdHeader header;
    header.bonds = reader.bonds();
    header.bond_origin_names = reader.bond_origin_names();
    header.masses = reader.masses();
    header.creator_version = std::string(version());
    header.parameters = pattern_.parameters;
    for (auto& [path, value] : header.parameters) {
      if (path == "run/walker") value = walker;
      if (path == "run/steps") value = options_.steps;
    }
    header.inputs = pattern_.inputs;
    H5mdOptions options = record_options();
    options.single = is_set("record/single");
    options.compress = is_set("record/compress");
    options.precision = recorded_precision();
    return std::make_shared<H5mdRecorder>(path_of(file), pattern_.framework, header, options);
  }

  double recorded_precision() const {
    for (const auto& [name, value] : pattern_.parameters)
      if (name == "record/precision" && std::holds_alternative<double>(value))
        return std::get<double>(value);
    return 0.0;
  }

  bool is_set(const std::string& path) const {
    for (const auto& [name, value] : pattern_.parameters)
      if (name == path) return value == Parameter(true);
    return false;
  }

  void check_same_run(const H5mdCheckpoint& other, std::int64_t walker) const {
    const auto refuse = [&](const std::string& what) {
      throw InputError(path_text(other.path) + ": is of another run than " +
                       path_text(pattern_.path) + ": " + what + " differs");
    };
    const auto& a = pattern_.framework;
    const auto& b = other.framework;
    if (!std::ranges::equal(a.bars(), b.bars()) ||
        !std::ranges::equal(a.rest_lengths(), b.rest_lengths()))
      refuse("the framework");
    if (other.parameters.size() != pattern_.parameters.size()) refuse("what its parameters are");
    for (std::size_t k = 0; k < other.parameters.size(); ++k) {
      const auto& [path, value] = other.parameters[k];
      if (path == "run/steps") continue;
      const Parameter expected = path == "run/walker" && settings_.job.walkers.are_several()
                                     ? Parameter(walker)
                                     : pattern_.parameters[k].second;
      if (path != pattern_.parameters[k].first || value != expected) refuse("/parameters/" + path);
    }
  }

  const RunSettings& settings_;
  std::optional<std::int64_t> steps_;
  H5mdCheckpoint pattern_;
  RunOptions options_;
  const Log& log_;
  ProgressBar& progress_;
  std::mutex showing_;
  std::int64_t frames_shown_ = 0;           ///< under the mutex
  std::vector<std::int64_t> frames_added_;  ///< by walker
};

void check_steps(const H5mdCheckpoint& from, const Log& log) {
  if (from.done > from.steps)
    throw OptionError(
        fmt::format("--steps {}: {} has {} steps already; steps are counted from the "
                    "start of the run",
                    from.steps, path_text(from.path), from.done));
  if (from.last_step >= from.began + from.steps)
    log.note(fmt::format("{} has all of its {} steps; --steps N goes on up to step N",
                         path_text(from.path), from.steps));
}

void refuse_samples(const H5mdCheckpoint& from) {
  if (from.is_sample())
    throw InputError(path_text(from.path) +
                     ": holds frames of pliant sample: pliant sample --continue goes on with them");
}

}  // namespace

int continue_run(const CommandLine& line, RunSettings& settings) {
  number_walkers(line, settings);
  if (settings.job.walkers.threads == 0)
    settings.job.walkers.threads = std::thread::hardware_concurrency();
  if (line.was_given("--imd"))
    throw OptionError("--imd: does not go with --continue, which adds to " + settings.job.go_on);
  Messages messages(settings.printing.json || settings.printing.quiet);
  const Log log = messages.log();
  std::optional<std::int64_t> steps;
  if (line.was_given("--steps")) steps = settings.job.run.steps;
  const Job given = settings.job;
  settings.job.output.output = settings.job.go_on;
  settings.job.output.topology = no_topology;
  const std::string first = output_of(settings, first_begun(settings));
  H5mdCheckpoint pattern = read_checkpoint(path_of(first), steps, log);
  refuse_samples(pattern);
  check_options_again(line, given, parameters_of(settings, pattern.framework, given.walkers.first),
                      pattern);
  check_steps(pattern, log);
  const RunOptions options = run_options_from(pattern);
  // The file of one walker of several goes on as that walker.
  if (!settings.job.walkers.are_several())
    settings.job.walkers.first = static_cast<std::int64_t>(options.resolve.walker);
  if (settings.printing.dry_run) return exit_ok;
  watch_for_interrupt();
  ProgressBar progress(settings.job.walkers.walkers * pattern.steps / options.every, "frames",
                       settings.printing.quiet);
  const Framework framework = pattern.framework;
  ContinuedRun continued(settings, steps, std::move(pattern), log, progress);
  const std::vector<RunSummary> summaries = continued.run();
  settings.job.run = continued.options();
  if (settings.printing.json) {
    print_run_json(settings, framework, summaries, messages.warnings());
  } else if (!settings.printing.quiet) {
    print_run_table(settings, framework, summaries);
  }
  return exit_code_of(added_up(summaries));
}

}  // namespace pliant::app
