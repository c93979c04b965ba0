// SPDX-License-Identifier: MIT
#include "pliant/jobs/replayed_events.hpp"

#include <algorithm>

#include "pliant/base/error.hpp"
#include "pliant/base/printable.hpp"
#include "pliant/run/replay_events.hpp"
#include "pliant/run/run_fields.hpp"

namespace pliant {
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
void check_options(const Job& job, const ReplayedForces& replayed) {
  const std::string says =
      printable_name(job.walkers.forces) + " says itself, step by step, what is done";
  for (const RunField& field : run_fields()) {
    const std::string option = option_name(field.name);
    if (field.name == "every" || !job.was_given(field.name)) continue;
    const std::string given = run_field_text(job.run, field);
    const std::string made = field.name == "steps" ? std::to_string(steps_of(replayed.events))
                                                   : values_in(replayed.events, field);
    if (given != made) throw OptionError(option + ": " + says + ": " + made + ", not " + given);
  }
  for (const char* option : {"ordering", "record_forces", "walkers", "shard"})
    if (job.was_given(option)) throw OptionError(option_name(option) + ": " + says);
  if (job.is_live) throw OptionError("--imd: " + says);
  if (!pushers_of(job.run.guide).empty())
    throw OptionError("--rock, --pull, --pair-distance: " + says);
}

/// The settings and pins before the first step, for the summary.
void note_what_is_taken(ReplayedForces& replayed) {
  for (const ForceEvent& event : replayed.events) {
    if (const auto* set = std::get_if<SetOption>(&event.what)) {
      replayed.taken.emplace_back(set->name, set->value);
    } else if (const auto* pins = std::get_if<PinJoints>(&event.what)) {
      replayed.taken.emplace_back("pins", std::to_string(pins->joints.size()));
    } else if (!std::holds_alternative<StartWalk>(event.what) &&
               !std::holds_alternative<HoldBack>(event.what)) {
      return;
    }
  }
}

}  // namespace

void take_events(Job& job, ReplayedForces& replayed, const RunSubject& subject) {
  replayed.events = parse_force_events(without_byte_order_mark(replayed.text), job.walkers.forces,
                                       subject.framework);
  if (steps_of(replayed.events) == 0)
    throw InputError(printable_name(job.walkers.forces) + ": holds no step");
  check_events(subject.framework,
               State(std::vector<Vec3>(subject.start.begin(), subject.start.end())),
               replayed.events, job.walkers.forces);
  check_options(job, replayed);
  note_what_is_taken(replayed);
  job.run = options_after(job.run, replayed.events, subject.framework);
}

}  // namespace pliant
