// SPDX-License-Identifier: MIT
// Tables of the options of a task. A row has an option's name, meaning, unit and range, where it is
// stored and who may set it. The command's options, Python's keywords, the page's settings, the
// parameters of a recorded file and check() all come from such a table.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "pliant/base/parameter.hpp"
#include "pliant/base/range.hpp"

namespace pliant {

/// Several names, given with commas between them.
using OptionNames = std::vector<std::string>;
/// Groups of words, one each time that the option is given.
using OptionGroups = std::vector<std::vector<std::string>>;

/// Where an option lies.
using OptionPlace = std::variant<bool*, std::int64_t*, std::uint64_t*, double*, std::string*,
                                 OptionNames*, OptionGroups*>;

/// Who may set an option. Where some may not, their program chooses the value itself.
struct OptionUsers {
  bool command = true;
  bool job = true;  ///< a job that is written as JSON, as shards are
  bool python = true;
  bool page = true;
  bool file = true;   ///< a recorded file, which a run or a sample goes on from
  bool again = true;  ///< whether it may be given where a job goes on
};

/// What an option is, wherever it is stored.
struct OptionFacts {
  std::string_view name;          ///< "max_sweeps": --max-sweeps, max_sweeps=, run/max_sweeps
  char letter = 0;                ///< of the command's short option, as in -o; 0: none
  std::string_view group = {};    ///< the heading under which help lists it
  std::string_view summary = {};  ///< what it means; in the command's words where those differ
  Range range = Range::any;       ///< what a number may be
  std::int64_t least = 0;         ///< of a whole number, where `range` does not say it
  double largest = HUGE_VAL;      ///< number, whoever sets it
  /// The names that a text may be, and what they are names of; null: any text, of that kind.
  std::vector<std::string_view> (*choices)() = nullptr;
  std::string_view kind = {};
  bool is_optional = false;           ///< 0 or "" stands for "not used" and is in range too
  bool is_file = false;               ///< a text is the name of a file, recorded without its folder
  std::size_t words = 0;              ///< words in each of OptionGroups
  std::string_view unit = {};         ///< of a number; "": none, or the summary says it
  std::string_view in_python = {};    ///< the summary in the words of scripts; "": the same
  std::string_view automatic = {};    ///< what a user may give in place of a choice, and gives if
                                      ///< nothing; a task then chooses
  std::int64_t most = INT64_MAX;      ///< whole numbers that the command takes
  std::string_view opposite = {};     ///< what the command calls a flag that is true if not given
  std::string_view unset_means = {};  ///< what the command does where it is not given, if that is
                                      ///< not the default of the library
  OptionUsers users = {};
  std::string_view recorded = {};        ///< path below /parameters; "": group of the table/name
  std::string_view type_in_python = {};  ///< what scripts may give, where it is more than one type
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

/// As messages name an option: "--max-sweeps" for the command, "max_sweeps" for scripts, which have
/// no `dashes`.
std::string option_name(std::string_view field, std::string_view dashes = "--");

/// What the command calls an option: that of a flag that is true if not given is its opposite.
std::string option_name(const OptionFacts& facts);

/// Returns the least and the largest whole number that the command and the page take.
std::int64_t least_taken(const OptionFacts& facts);
std::int64_t largest_taken(const OptionFacts& facts);

/// Throws OptionError naming the option, its value and what it must be.
void check_option(const OptionFacts& facts, OptionPlace place);

/// Sets an option from text: "true" or "false", a number, a name. Throws OptionError naming it, the
/// text and what was expected. Ranges are checked by check_option(), not here.
void set_option(const OptionFacts& facts, OptionPlace place, std::string_view text);

/// The value as text that set_option() reads back to the same bits.
std::string option_text(OptionPlace place);

/// The value as files keep it. A seed is text, since 64 bits without sign do not fit a Parameter;
/// names and words are text, too.
Parameter parameter_of(const OptionFacts& facts, OptionPlace place);

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

/// The path of an option below /parameters: "sample/seed".
std::string recorded_path(std::string_view group, const OptionFacts& facts);

/// Options of a table as files keep them, each below `group`: "sample/seed".
template <class Fields, class Options>
std::vector<NamedParameter> option_parameters(std::string_view group, const Fields& fields,
                                              const Options& options) {
  std::vector<NamedParameter> values;
  for (const auto& field : fields)
    if (field.users.file)
      values.emplace_back(recorded_path(group, field),
                          parameter_of(field, field.place(places_of(options))));
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
    const std::string path = recorded_path(group, field);
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

/// A row of one of the tables of a job, which holds options of several kinds.
template <class Job>
struct OptionRow {
  const OptionFacts* facts;
  std::string path;  ///< below /parameters
  std::function<OptionPlace(Job&)> place;
};

/// Adds the rows of a table whose options lie at `at` of a job: append_rows(rows, "sample",
/// sample_fields(), [](Job& job) -> SampleOptions& { return job.sample; }).
template <class Job, class Fields, class At>
void append_rows(std::vector<OptionRow<Job>>& rows, std::string_view group, const Fields& fields,
                 At at) {
  for (const auto& field : fields)
    rows.push_back({&field, recorded_path(group, field),
                    [&field, at](Job& job) { return field.place(at(job)); }});
}

}  // namespace pliant
