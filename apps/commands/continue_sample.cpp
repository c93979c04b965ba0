// SPDX-License-Identifier: MIT
#include "commands/continue_sample.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>

#include "commands/show_sample.hpp"
#include "interrupt.hpp"
#include "messages.hpp"
#include "options/option_comparison.hpp"
#include "options/option_fields.hpp"
#include "output/output_files.hpp"
#include "output/sample_report.hpp"
#include "pliant/base/error.hpp"
#include "pliant/base/printable.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/framework/measures/limit_counts.hpp"
#include "pliant/jobs/recorded_sample.hpp"

namespace pliant::app {
namespace {

constexpr const char* options_of_a_new_sample[] = {"--format", "--topology", "--overwrite"};

std::string recorded_text(const H5mdCheckpoint& from, const std::string& path) {
  for (const auto& [name, value] : from.parameters)
    if (name == path && std::holds_alternative<std::string>(value))
      return std::get<std::string>(value);
  return {};
}

H5mdCheckpoint read_sample(const CommandLine& line, const SampleSettings& settings,
                           const Log& log) {
  std::error_code error;
  if (!std::filesystem::exists(path_of(settings.go_on), error))
    throw FileError(not_there(settings.go_on));
  std::optional<std::int64_t> frames;
  if (line.was_given("--frames")) frames = settings.sample.frames;
  H5mdCheckpoint from = read_checkpoint(path_of(settings.go_on), frames, log);
  if (!from.is_sample())
    throw InputError(path_text(from.path) +
                     ": holds steps of pliant run: pliant run --continue goes on with them");
  return from;
}

/// The path at which files keep an option; for the amplitude it is what was asked for, which may be
/// a file.
std::string recorded_path(const SampleField& field) {
  const bool is_asked = field.name == "amplitude";
  return "sample/" + std::string(field.name) + (is_asked ? "_from" : "");
}

/// Which kind of model `auto` took is in the file.
void check_options_again(const CommandLine& line, SampleSettings given,
                         const H5mdCheckpoint& recorded) {
  refuse_options_of_a_new_file(line, options_of_a_new_sample, recorded.path);
  given.molecule.kind.name =
      given.model == "auto" ? recorded_text(recorded, "model/kind") : given.model;
  const OptionComparison comparison(line, parameters_of(given), recorded);
  comparison.check_both();
  comparison.check("--model", "model/kind");
  comparison.check("--free-torsions", "model/free_torsions");
  for (const SampleField& field : sample_fields())
    if (field.users.file && field.name != "frames")
      comparison.check(option_name(field.name), recorded_path(field));
  if (recorded.done > recorded.steps)
    throw OptionError(
        fmt::format("--frames {}: {} has {} frames already; frames are counted from "
                    "the start of the sample",
                    recorded.steps, path_text(recorded.path), recorded.done));
}

SampleSummary add_frames(const SampleSettings& settings, const H5mdCheckpoint& from) {
  ProgressBar progress(from.steps - from.done, "frames", settings.quiet);
  SampleOptions options = settings.sample;
  options.should_stop = interrupted;
  std::int64_t done = 0;
  return pliant::add_frames(from, options, settings.record, [&](const Frame&) {
    progress.show(++done);
    return interrupted();
  });
}

}  // namespace

int continue_sample(const CommandLine& line, SampleSettings& settings) {
  refuse_another_output(line, settings.output, settings.go_on);
  settings.output = settings.go_on;
  settings.topology = "none";
  Messages messages(settings.json || settings.quiet);
  const H5mdCheckpoint from = read_sample(line, settings, messages.log());
  check_options_again(line, settings, from);
  settings.molecule.file = recorded_text(from, "input/file");
  const std::int64_t threads = settings.sample.threads;
  settings.sample = sample_options_from(from);
  settings.sample.threads = threads;
  settings.chosen_amplitude = {settings.sample.amplitude,
                               recorded_text(from, "sample/amplitude_from"),
                               recorded_text(from, "sample/amplitude_reason")};
  if (settings.dry_run) return exit_ok;
  settings.record.log = messages.log();
  watch_for_interrupt();
  SampleSummary summary;
  if (from.done < from.steps)
    summary = add_frames(settings, from);
  else
    messages.log().note(
        fmt::format("{} has all of its {} frames; --frames N goes on up to N in all",
                    path_text(from.path), from.steps));
  const std::string kind = recorded_text(from, "model/kind");  // the system refers to it
  SampledSystem system{kind, from.framework, from.inputs.start,
                       LimitCounter(from.framework.limits()).size()};
  if (std::string left_out = recorded_text(from, "model/left_out"); !left_out.empty())
    system.left_out.push_back(std::move(left_out));
  print_sample(settings, system, summary, messages.warnings());
  return shown(settings, exit_code_of(summary));
}

}  // namespace pliant::app
