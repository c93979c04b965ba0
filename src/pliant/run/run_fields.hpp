// SPDX-License-Identifier: MIT
// The table of the options of a run: name, meaning, unit and range of each, and where it lies. The
// command's options, Python's keywords, the parameters of a recorded file and check() all come from
// it: an option is added here and is there for all of them.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "pliant/base/parameter.hpp"
#include "pliant/base/range.hpp"
#include "pliant/run/run.hpp"

namespace pliant {

/// Where an option lies in a RunOptions. Text is always a name of some table.
using RunPlace = std::variant<bool*, std::int64_t*, std::uint64_t*, double*, std::string*>;

/// The headings under which a command lists options.
enum class RunGroup : std::uint8_t { run, technique, perturbation };

/// One option of a run.
struct RunField {
  std::string_view name;     ///< "max_sweeps": --max-sweeps, max_sweeps=, run/max_sweeps
  RunGroup group;            ///< under which heading it stands
  std::string_view summary;  ///< what it means, with its unit
  Range range;               ///< what a number may be
  RunPlace (*place)(RunOptions& options);
  /// The names that a text may be, and what they are names of; null for what is no text.
  std::vector<std::string_view> (*choices)() = nullptr;
  std::string_view kind = {};
  bool is_optional = false;  ///< 0 stands for "not used" and is in range too
};

std::span<const RunField> run_fields();

/// The row of that name. Throws OptionError listing the known names.
const RunField& find_run_field(std::string_view name);

/// Sets an option from text: "true" or "false", a number, a name. Throws OptionError naming it, the
/// text and what was expected; ranges are check_fields()' matter.
void set_run_field(RunOptions& options, std::string_view name, std::string_view text);

/// The value of an option as text that set_run_field() reads back to the same bits.
std::string run_field_text(const RunOptions& options, const RunField& field);

/// Throws OptionError naming the first option that is out of its range or no known name, the value
/// and what it must be.
void check_fields(const RunOptions& options);

/// What is recorded as the perturbation of a run that replayed a force file with events. Nothing
/// goes on with such a run.
inline constexpr std::string_view events_perturbation = "events";

/// Every option by its path below /parameters: "run/max_sweeps". Two things more: "run/walker", and
/// "run/technique_used", what `auto` chose for this framework. A seed is text, since 64 bits
/// without sign do not fit a Parameter; of a replay "run/perturb" is "replay",
/// of a guide "rock", "pull" or "pair_distance", joined by "+".
std::vector<NamedParameter> parameters_of(const RunOptions& options, const Framework& framework);

/// The inverse: options of a recorded run. Without what is not recorded: a technique's own ordering
/// or sweep, the forces of a replay, and a guide. Throws InputError naming a path that is missing
/// or has an invalid value.
RunOptions run_options_from(const std::vector<NamedParameter>& parameters);

/// Whether the recorded run followed a guide. Throws InputError where the file does not say.
bool is_guided_run(const std::vector<NamedParameter>& parameters);

}  // namespace pliant
