// SPDX-License-Identifier: MIT
// Command-line options with strict values: decimal numbers in a given range, names from a table. An
// error names the option, the bad value and what was expected.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "command.hpp"
#include "pliant/base/range.hpp"

namespace pliant::app {

/// The options of one subcommand, its help, and which options were given. Names are "--steps",
/// "-o,--output", or without a dash for a positional argument. Values must outlive it: parse() sets
/// them, and their values before are the defaults that the help shows.
///
/// CLI11, which implements it, takes seconds to compile in every file that includes it.
class CommandLine {
 public:
  CommandLine(const std::string& command, const std::string& summary);
  ~CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  /// Sets the text below all options in the help.
  void set_footer(const std::string& text);

  /// Lists options added from here on under this heading in the help.
  void start_group(const std::string& heading);

  /// Names the options that --help shows, and --help-all does not stop at. Not called, both show
  /// all.
  void set_common(const std::vector<std::string>& names);

  /// Sets `value` when given; with `add_opposite` there is an option that clears it, too.
  void add_flag(const std::string& name, bool& value, const std::string& help);
  void add_opposite(const std::string& name, bool& value, const std::string& help);

  /// Adds any text; `type` is its placeholder in the help. The name of a FILE must not be empty.
  void add_text(const std::string& name, std::string& value, const std::string& type,
                const std::string& help);
  void add_required_text(const std::string& name, std::string& value, const std::string& type,
                         const std::string& help);

  /// Makes the text optional if `option` is given.
  void not_required_with(const std::string& name, const std::string& option);

  /// Adds a whole number in [least, most]. The help shows `fallback` in place of the value.
  void add_integer(const std::string& name, std::int64_t& value, std::int64_t least,
                   std::int64_t most, const std::string& help, const char* fallback = nullptr);

  /// Adds a text that may follow the option; without one the value does not change. The help shows
  /// `fallback` for it.
  void add_optional_text(const std::string& name, bool& is_asked, std::string& value,
                         const std::string& type, const std::string& fallback,
                         const std::string& help);

  /// Adds a 64-bit number without sign.
  void add_seed(const std::string& name, std::uint64_t& value, const std::string& help);

  /// Adds a finite real number in `range`. The help shows `fallback` in place of the value.
  void add_real(const std::string& name, double& value, Range range, const std::string& help,
                const char* fallback = nullptr);

  /// Adds names separated by commas; the help shows `fallback` for what holds without any.
  void add_names(const std::string& name, std::vector<std::string>& values,
                 const std::string& fallback, const std::string& help);

  /// Adds groups of `size` words, one each time that the option is given; `type` is their
  /// placeholder.
  void add_groups(const std::string& name, std::vector<std::vector<std::string>>& values,
                  std::size_t size, const std::string& type, const std::string& help);

  /// Adds finite real numbers in `range`, separated by commas.
  void add_reals(const std::string& name, std::vector<double>& values, Range range,
                 const std::string& fallback, const std::string& help);

  /// Adds one of `names`.
  void add_choice(const std::string& name, std::string& value,
                  const std::vector<std::string_view>& names, const std::string& help);

  /// Returns -1 to continue, else the exit code (help or an error was printed).
  int parse(const Arguments& arguments);

  /// Counts an option as given that came from elsewhere.
  void note_given(const std::string& name);

  /// Whether parse() found the option; false of one that the command does not have.
  bool was_given(const std::string& name) const;

 private:
  struct Parser;
  std::unique_ptr<Parser> parser_;
};

}  // namespace pliant::app
