// SPDX-License-Identifier: MIT
#include "options/force_events_input.hpp"

#include <algorithm>

#include "options/option_fields.hpp"
#include "pliant/base/error.hpp"
#include "pliant/base/printable.hpp"
#include "pliant/run/replay_events.hpp"
#include "pliant/run/run_fields.hpp"

namespace pliant::app {
namespace {

/// What an option is in each step, where it is not the same in all of them: "auto, newton".
std::string values_in(const std::vector<ForceEvent>& events, const RunField& field) {
  std::vector<std::string> values;
  RunOptions options;
  for (const ForceEvent& event : events) {
    const auto* set = std::get_if<SetOption>(&event.what);
    if (set != nullptr) set_run_field(options, set->name, set->value);
    const std::string now = run_field_text(options, field);
    const bool is_step = std::holds_alternative<PullStep>(event.what) ||
                         std::holds_alternative<WanderSteps>(event.what);
    if (is_step && std::ranges::find(values, now) == values.end()) values.push_back(now);
  }
  std::string text;
  for (const std::string& value : values) text += (text.empty() ? "" : ", ") + value;
  return text;
}

/// A file of events is one walker's way, step by step.
void check_options(const CommandLine& line, const RunSettings& settings) {
  const std::string says =
      printable_name(settings.job.walkers.forces) + " says itself, step by step, what is done";
  for (const RunField& field : run_fields()) {
    const std::string option = option_name(field.name);
    if (field.name == "every" || !line.was_given(option)) continue;
    const std::string given = run_field_text(settings.job.run, field);
    const std::string made = field.name == "steps" ? std::to_string(steps_of(settings.events))
                                                   : values_in(settings.events, field);
    if (given != made) throw OptionError(option + ": " + says + ": " + made + ", not " + given);
  }
  for (const char* option : {"--ordering", "--record-forces", "--walkers", "--shard", "--imd"})
    if (line.was_given(option)) throw OptionError(std::string(option) + ": " + says);
  if (!pushers_of(settings.job.run.guide).empty())
    throw OptionError("--rock, --pull, --pair-distance: " + says);
}

/// The settings and pins before the first step, for the summary.
void note_what_is_taken(RunSettings& settings) {
  for (const ForceEvent& event : settings.events) {
    if (const auto* set = std::get_if<SetOption>(&event.what)) {
      settings.taken_from_forces.emplace_back(set->name, set->value);
    } else if (const auto* pins = std::get_if<PinJoints>(&event.what)) {
      settings.taken_from_forces.emplace_back("pins", std::to_string(pins->joints.size()));
    } else if (!std::holds_alternative<StartWalk>(event.what) &&
               !std::holds_alternative<HoldBack>(event.what)) {
      return;
    }
  }
}

}  // namespace

void take_events(const CommandLine& line, RunSettings& settings, const Molecule& molecule,
                 std::string_view text) {
  settings.events = parse_force_events(text, settings.job.walkers.forces, molecule.framework);
  if (steps_of(settings.events) == 0)
    throw InputError(printable_name(settings.job.walkers.forces) + ": holds no step");
  check_events(molecule.framework, State(molecule.structure.positions), settings.events,
               settings.job.walkers.forces);
  check_options(line, settings);
  note_what_is_taken(settings);
  settings.job.run = options_after(settings.job.run, settings.events, molecule.framework);
}

}  // namespace pliant::app
