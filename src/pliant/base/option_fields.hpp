// SPDX-License-Identifier: MIT
// Tables of the options of a task. A row has an option's name, meaning, unit and range, where it is
// stored and who may set it. The command's options, Python's keywords, the page's settings, the
// parameters of a recorded file and check() all come from such a table.
#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "pliant/base/parameter.hpp"
#include "pliant/base/range.hpp"

namespace pliant {

/// Where an option lies.
using OptionPlace = std::variant<bool*, std::int64_t*, std::uint64_t*, double*, std::string*>;

/// Who may set an option. Where some may not, their program chooses the value itself.
struct OptionUsers {
  bool command = true;
  bool python = true;
  bool page = true;
  bool file = true;  ///< a recorded file, which a run or a sample goes on from
};

/// What an option is, wherever it is stored.
struct OptionFacts {
  std::string_view name;          ///< "max_sweeps": --max-sweeps, max_sweeps=, run/max_sweeps
  std::string_view group = {};    ///< the heading under which help lists it
  std::string_view summary = {};  ///< what it means; in the command's words where those differ
  Range range = Range::any;       ///< what a number may be
  double largest = HUGE_VAL;      ///< number, whoever sets it
  /// The names that a text may be, and what they are names of; null: any text, of that kind.
  std::vector<std::string_view> (*choices)() = nullptr;
  std::string_view kind = {};
  bool is_optional = false;           ///< 0 stands for "not used" and is in range too
  std::string_view unit = {};         ///< of a number; "": none, or the summary says it
  std::string_view in_python = {};    ///< the summary in the words of scripts; "": the same
  std::string_view automatic = {};    ///< what a user may give in place of a choice, and gives if
                                      ///< nothing; a task then chooses
  std::int64_t most = INT64_MAX;      ///< whole numbers that the command takes
  std::string_view opposite = {};     ///< what the command calls a flag that is true if not given
  std::string_view unset_means = {};  ///< what the command does where it is not given, if that is
                                      ///< not the default of the library
  OptionUsers users = {};
};

/// A row of a table, for options of one kind.
template <class Options>
struct OptionField : OptionFacts {
  OptionPlace (*place)(Options& options) = nullptr;
};

/// The member that a chain of members leads to; for `place` of a row: place_at<RunOptions,
/// &RunOptions::resolve, &ResolveOptions::seed>.
template <auto First, auto... Rest>
OptionPlace follow_members(auto& from) {
  if constexpr (sizeof...(Rest) == 0) {
    return &(from.*First);
  } else {
    return follow_members<Rest...>(from.*First);
  }
}
template <class Options, auto... Members>
OptionPlace place_at(Options& options) {
  return follow_members<Members...>(options);
}

/// Returns the largest whole number that the command and the page take.
std::int64_t largest_taken(const OptionFacts& facts);

/// Throws OptionError naming the option, its value and what it must be.
void check_option(const OptionFacts& facts, OptionPlace place);

/// Sets an option from text: "true" or "false", a number, a name. Throws OptionError naming it, the
/// text and what was expected. Ranges are checked by check_option(), not here.
void set_option(const OptionFacts& facts, OptionPlace place, std::string_view text);

/// The value as text that set_option() reads back to the same bits.
std::string option_text(OptionPlace place);

/// The value as files keep it. A seed is text, since 64 bits without sign do not fit a Parameter.
Parameter parameter_of(OptionPlace place);

/// Returns the parameter of that path. Throws InputError where there is none.
const Parameter& find_parameter(const std::vector<NamedParameter>& parameters,
                                const std::string& path);

/// Sets an option to what was recorded. Throws InputError naming a path that is missing or has an
/// invalid value.
void restore_option(const std::vector<NamedParameter>& parameters, const std::string& path,
                    OptionPlace place);

/// Lets the functions above read options that are const; a copy would copy the forces of a replay.
template <class Options>
Options& places_of(const Options& options) {
  return const_cast<Options&>(options);
}

/// Options of a table as files keep them, each below `group`: "sample/seed".
template <class Fields, class Options>
std::vector<NamedParameter> option_parameters(std::string_view group, const Fields& fields,
                                              const Options& options) {
  std::vector<NamedParameter> values;
  for (const auto& field : fields)
    if (field.users.file)
      values.emplace_back(std::string(group) + "/" + std::string(field.name),
                          parameter_of(field.place(places_of(options))));
  return values;
}

/// Whether there is a parameter of that path.
bool has_parameter(const std::vector<NamedParameter>& parameters, const std::string& path);

/// Sets options from recorded parameters. Fields that files do not keep are left as they are, and
/// so are those that this file lacks: it is older than the option, whose default is what was done
/// before. Only the first of a table is in all files. Throws as restore_option().
template <class Fields, class Options>
void restore_options(std::string_view group, const Fields& fields,
                     const std::vector<NamedParameter>& parameters, Options& options) {
  bool is_needed = true;
  for (const auto& field : fields) {
    const std::string path = std::string(group) + "/" + std::string(field.name);
    if (field.users.file && (is_needed || has_parameter(parameters, path)))
      restore_option(parameters, path, field.place(options));
    is_needed = false;
  }
}

/// Sets to "automatic" every option that the task can choose.
template <class Fields, class Options>
void leave_open(const Fields& fields, Options& options) {
  for (const auto& field : fields)
    if (!field.automatic.empty())
      *std::get<std::string*>(field.place(options)) = std::string(field.automatic);
}

}  // namespace pliant
