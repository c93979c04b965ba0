// SPDX-License-Identifier: MIT
// Command-line options with strict values: whole decimal numbers in a stated range, names from a
// table. A bad value is named with its option and what was expected.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "command.hpp"
#include "pliant/base/range.hpp"

namespace pliant::app {

/// The options of one subcommand, how its help reads and what was given. Names are "--steps",
/// "-o,--output", or without a dash for an argument told by its place. Values must outlive it: they
/// are set by parse(), and what they are before is the default that the help shows.
///
/// CLI11 is behind it, which takes seconds to compile in every file that includes it.
class CommandLine {
 public:
  CommandLine(const std::string& command, const std::string& summary);
  ~CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  /// The text below all options in the help.
  void set_footer(const std::string& text);

  /// Options added from here on stand under this heading in the help.
  void start_group(const std::string& heading);

  /// True if set when given, or with `add_opposite` false.
  void add_flag(const std::string& name, bool& value, const std::string& help);
  void add_opposite(const std::string& name, bool& value, const std::string& help);

  /// Any text; `type` says in the help what it stands for. The name of a FILE is not empty.
  void add_text(const std::string& name, std::string& value, const std::string& type,
                const std::string& help);
  void add_required_text(const std::string& name, std::string& value, const std::string& type,
                         const std::string& help);

  /// The text need not be given where that option is.
  void not_required_with(const std::string& name, const std::string& option);

  /// A whole number of [least, most]. `fallback` is what the help shows in place of the value.
  void add_integer(const std::string& name, std::int64_t& value, std::int64_t least,
                   std::int64_t most, const std::string& help, const char* fallback = nullptr);

  /// A whole number that need not follow the option: without one the value stays.
  void add_optional_integer(const std::string& name, bool& is_asked, std::int64_t& value,
                            std::int64_t least, std::int64_t most, const std::string& type,
                            const std::string& help);

  /// A 64-bit number without sign.
  void add_seed(const std::string& name, std::uint64_t& value, const std::string& help);

  /// A finite real number in `range`. `fallback` is what the help shows in place of the value.
  void add_real(const std::string& name, double& value, Range range, const std::string& help,
                const char* fallback = nullptr);

  /// A number that an earlier version took by this name: the error says what it `is_now`, the name
  /// of an option, a comma and its unit, and gives the value times `factor`. It is not in the help.
  void add_former_real(const std::string& name, const std::string& is_now, double factor);

  /// Names set apart by commas; `fallback` says in the help what holds if there are none.
  void add_names(const std::string& name, std::vector<std::string>& values,
                 const std::string& fallback, const std::string& help);

  /// `size` words each time that the option is given; `type` says what they stand for.
  void add_groups(const std::string& name, std::vector<std::vector<std::string>>& values,
                  std::size_t size, const std::string& type, const std::string& help);

  /// Finite real numbers in `range`, set apart by commas.
  void add_reals(const std::string& name, std::vector<double>& values, Range range,
                 const std::string& fallback, const std::string& help);

  /// One of `names`.
  void add_choice(const std::string& name, std::string& value,
                  const std::vector<std::string_view>& names, const std::string& help);

  /// A whole number of [least, most], else one of `names`, which goes to `word`.
  void add_integer_or_choice(const std::string& name, std::int64_t& value, std::int64_t least,
                             std::int64_t most, std::string& word,
                             const std::vector<std::string_view>& names, const std::string& help);

  /// Returns -1 to go on, else the exit code to end with (help was printed, or the error).
  int parse(const Arguments& arguments);

  /// Whether parse() met the option.
  bool was_given(const std::string& name) const;

 private:
  struct Parser;
  std::unique_ptr<Parser> parser_;
};

}  // namespace pliant::app
