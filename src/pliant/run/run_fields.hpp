// SPDX-License-Identifier: MIT
// The table of the options of a run: name, meaning, unit, range and place of each. The command's
// options, Python's keywords, the parameters of a recorded file and check() all come from it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pliant/base/option_fields.hpp"
#include "pliant/run/run_options.hpp"

namespace pliant {

/// One option of a run.
using RunField = OptionField<RunOptions>;

std::span<const RunField> run_fields();

/// The row of that name. Throws OptionError listing the known names.
const RunField& find_run_field(std::string_view name);

/// Sets an option from text: "true" or "false", a number, a name. Throws OptionError naming it, the
/// text and what was expected. Ranges are checked by check_fields(), not here.
void set_run_field(RunOptions& options, std::string_view name, std::string_view text);

/// The value of an option as text that set_run_field() reads back to the same bits.
std::string run_field_text(const RunOptions& options, const RunField& field);

/// Throws OptionError for the first option that is out of its range or no known name, naming it,
/// the value and what it must be.
void check_fields(const RunOptions& options);

/// The perturbation recorded for a run that replayed a force file with events. Such a run cannot
/// continue.
inline constexpr std::string_view events_perturbation = "events";

/// Every option by its path below /parameters: "run/max_sweeps". Two more are "run/walker", and
/// "run/technique_used", the choice of `auto` for this framework. A seed is text, since 64 bits
/// without sign do not fit a Parameter. In a replay "run/perturb" is "replay", with a guide "rock",
/// "pull" or "pair_distance", joined by "+".
std::vector<NamedParameter> parameters_of(const RunOptions& options, const Framework& framework);

/// Reads the options of a recorded run, without what is not recorded: a technique's own ordering or
/// sweep, the forces of a replay, and a guide. Throws InputError naming a path that is missing or
/// has an invalid value.
RunOptions run_options_from(const std::vector<NamedParameter>& parameters);

/// Whether the recorded run followed a guide. Throws InputError where the file does not say.
bool is_guided_run(const std::vector<NamedParameter>& parameters);

}  // namespace pliant
