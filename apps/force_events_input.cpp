// SPDX-License-Identifier: MIT
#include "force_events_input.hpp"

#include <algorithm>

#include "pliant/base/error.hpp"
#include "pliant/base/printable.hpp"
#include "pliant/run/replay_events.hpp"
#include "pliant/run/run_fields.hpp"

namespace pliant::app {
namespace {

/// A file of events is one walker's way, step by step.
void check_options(const CommandLine& line, const RunSettings& settings) {
  const auto refuse = [&](const std::string& option) {
    throw OptionError(option + ": " + printable_name(settings.forces) +
                      " says itself, step by step, what is done");
  };
  for (const RunField& field : run_fields())
    if (field.name != "every" && line.was_given(option_name(field.name)))
      refuse(option_name(field.name));
  for (const char* option : {"--ordering", "--record-forces", "--walkers", "--shard", "--imd"})
    if (line.was_given(option)) refuse(option);
  if (!pushers_of(settings.run.guide).empty()) refuse("--rock, --pull, --pair-distance");
}

/// Frames of a file are judged by one tolerance: the loosest of any step.
class LoosestTolerance {
 public:
  void note(const Tolerance& one) {
    if (one.length > 0.0)
      length_ = std::max(length_, one.length);
    else
      relative_ = std::max(relative_, one.relative);
    loosest_.limit = std::max(loosest_.limit, one.limit);
    loosest_.overlap = std::max(loosest_.overlap, one.overlap);
  }

  /// Where steps had both kinds, as a length.
  Tolerance of(const Framework& framework) const {
    Tolerance all = loosest_;
    all.relative = relative_;
    double longest = 0.0;
    for (double rest : framework.rest_lengths()) longest = std::max(longest, rest);
    if (length_ > 0.0) all.length = std::max(length_, relative_ * longest);
    return all;
  }

 private:
  double relative_ = 0.0, length_ = 0.0;
  Tolerance loosest_;
};

/// The settings after the last event, and the loosest tolerance.
RunOptions recorded_options(RunOptions options, std::span<const ForceEvent> events,
                            const Framework& framework) {
  LoosestTolerance loosest;
  loosest.note(options.resolve.tolerance);  // of the start
  for (const ForceEvent& event : events) {
    if (const auto* set = std::get_if<SetOption>(&event.what))
      set_run_field(options, set->name, set->value);
    else
      loosest.note(options.resolve.tolerance);
  }
  options.resolve.tolerance = loosest.of(framework);
  options.steps = steps_of(events);
  return options;
}

}  // namespace

void take_events(const CommandLine& line, RunSettings& settings, const Molecule& molecule,
                 std::string_view text) {
  check_options(line, settings);
  settings.events = parse_force_events(text, settings.forces, molecule.framework);
  if (steps_of(settings.events) == 0)
    throw InputError(printable_name(settings.forces) + ": holds no step");
  check_events(molecule.framework, State(molecule.structure.positions), settings.events,
               settings.forces);
  settings.run = recorded_options(settings.run, settings.events, molecule.framework);
}

}  // namespace pliant::app
