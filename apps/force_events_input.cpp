// SPDX-License-Identifier: MIT
#include "force_events_input.hpp"

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

}  // namespace

void take_events(const CommandLine& line, RunSettings& settings, const Molecule& molecule,
                 std::string_view text) {
  check_options(line, settings);
  settings.events = parse_force_events(text, settings.forces, molecule.framework);
  if (steps_of(settings.events) == 0)
    throw InputError(printable_name(settings.forces) + ": holds no step");
  check_events(molecule.framework, State(molecule.structure.positions), settings.events,
               settings.forces);
  settings.run = options_after(settings.run, settings.events, molecule.framework);
}

}  // namespace pliant::app
