// SPDX-License-Identifier: MIT
// Command-line options with strict values: whole decimal numbers in a stated range, names from a
// table. A bad value is named with its option and what was expected.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "command.hpp"
#include "pliant/base/choices.hpp"

namespace pliant::app {

/// A whole number of [least, most].
CLI::Option* add_integer(CLI::App& app, const std::string& name, std::int64_t& value,
                         std::int64_t least, std::int64_t most, const std::string& help);

/// A 64-bit number without sign.
CLI::Option* add_seed(CLI::App& app, const std::string& name, std::uint64_t& value,
                      const std::string& help);

enum class Range { positive, zero_or_more, zero_to_one };

/// A finite real number in `range`.
CLI::Option* add_real(CLI::App& app, const std::string& name, double& value, Range range,
                      const std::string& help);

/// Names set apart by commas; `fallback` says in the help what holds if there are none.
CLI::Option* add_names(CLI::App& app, const std::string& name, std::vector<std::string>& values,
                       const std::string& fallback, const std::string& help);

/// Finite real numbers in `range`, set apart by commas.
CLI::Option* add_reals(CLI::App& app, const std::string& name, std::vector<double>& values,
                       Range range, const std::string& fallback, const std::string& help);

/// One of `names`.
CLI::Option* add_choice(CLI::App& app, const std::string& name, std::string& value,
                        const std::vector<std::string_view>& names, const std::string& help);

/// An app whose help and errors read as all of ours do.
void prepare(CLI::App& app);

/// Options added from here on stand under this heading in the help.
void start_group(CLI::App& app, const std::string& heading);

/// Parses. Returns -1 to go on, else the exit code to end with (help was printed, or the error).
int parse(CLI::App& app, const Arguments& arguments);

}  // namespace pliant::app
