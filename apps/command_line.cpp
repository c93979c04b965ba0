// SPDX-License-Identifier: MIT
#include "command_line.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <functional>
#include <set>

#include "option_wording.hpp"
#include "pliant/base/choices.hpp"
#include "pliant/base/number.hpp"

namespace pliant::app {
namespace {

[[noreturn]] void refuse(const std::string& name, const std::string& expected,
                         const std::string& found) {
  throw CLI::ValidationError(name, "expected " + expected + ", found " + pliant::quoted(found));
}

/// An option whose text is parsed by `parse`, which throws on a bad one.
void add_parsed(CLI::App& app, const std::string& name, const std::string& type,
                const std::string& fallback, const std::string& help,
                const std::function<void(const std::string&)>& parse) {
  app.add_option_function<std::string>(name, parse, help)->type_name(type)->default_str(fallback);
}

/// An option that stands for a file (FILE), or for what a file lists (N), is refused without a
/// name.
void expect_name(CLI::Option* option, const std::string& type) {
  const bool is_file = type.find("FILE") != std::string::npos;
  if (!is_file && type != "N") return;
  option->check([is_file](const std::string& text) -> std::string {
    const std::string of_file = is_file ? " of a file" : "";
    return text.empty() ? "expected the name" + of_file + ", found \"\"" : "";
  });
}

/// Numbers fill the whole argument: no blanks around them.
bool has_blanks(const std::string& text) { return text.find_first_of(" \t") != std::string::npos; }

double real_of(const std::string& name, Range range, const std::string& text) {
  const auto number = parse_real(text);
  if (!number || has_blanks(text) || !holds(range, *number)) refuse(name, wording(range), text);
  return *number;
}

/// "--no-such" with the nearest option that there is.
std::string unknown_options(const CLI::App& app) {
  std::vector<std::string> known;
  for (const CLI::Option* option : app.get_options()) known.push_back(option->get_name());
  const std::vector<std::string_view> views(known.begin(), known.end());
  std::string text;
  for (const std::string& word : app.remaining()) {
    text += (text.empty() ? "" : "; ") + std::string("unexpected argument ") + pliant::quoted(word);
    const std::string near = nearest_name(word, views);
    if (!near.empty()) text += " (did you mean " + near + "?)";
  }
  return text;
}

/// Never two empty lines in a row.
std::string single_spaced(std::string text) {
  for (auto at = text.find("\n\n\n"); at != std::string::npos; at = text.find("\n\n\n", at))
    text.erase(at, 1);
  return text;
}

}  // namespace

struct CommandLine::Parser {
  CLI::App app;
  std::vector<std::pair<std::string, std::string>> not_required_with = {};
  std::vector<std::string> common = {};
  std::set<std::string> given_elsewhere = {};

  std::string help() { return single_spaced(app.help()); }

  /// Shows the common options under one heading, and hides the others.
  std::string short_help() {
    if (common.empty()) {
      app.get_option("--help-all")->group("");
      return help();
    }
    std::size_t hidden = 0;
    for (CLI::Option* option : app.get_options()) {
      const bool is_shown = option->get_positional() || option == app.get_help_ptr() ||
                            option == app.get_help_all_ptr() ||
                            std::ranges::any_of(common, [&](const std::string& name) {
                              return option->check_name(name);
                            });
      if (!is_shown && !option->get_group().empty()) ++hidden;
      if (!option->get_positional()) option->group(is_shown ? "Options" : "");
    }
    app.get_option("--help-all")
        ->description(fmt::format("print the text with {} more options and exit", hidden));
    return help();
  }
};

CommandLine::CommandLine(const std::string& command, const std::string& summary)
    : parser_(new Parser{CLI::App(summary, command)}) {
  CLI::App& app = parser_->app;
  app.get_formatter()->column_width(32);
  app.option_defaults()->always_capture_default(false);
  app.set_help_flag("-h,--help", "print this text and exit");
  app.set_help_all_flag("--help-all", "print all options and exit");
}

CommandLine::~CommandLine() = default;

void CommandLine::set_footer(const std::string& text) { parser_->app.footer(text); }

void CommandLine::set_common(const std::vector<std::string>& names) { parser_->common = names; }

void CommandLine::start_group(const std::string& heading) {
  parser_->app.option_defaults()->group(heading);
}

void CommandLine::add_flag(const std::string& name, bool& value, const std::string& help) {
  parser_->app.add_flag(name, value, help);
}

void CommandLine::add_opposite(const std::string& name, bool& value, const std::string& help) {
  parser_->app.add_flag_callback(
      name, [&value] { value = false; }, help);
}

void CommandLine::add_text(const std::string& name, std::string& value, const std::string& type,
                           const std::string& help) {
  expect_name(parser_->app.add_option(name, value, help)->type_name(type), type);
}

void CommandLine::add_required_text(const std::string& name, std::string& value,
                                    const std::string& type, const std::string& help) {
  expect_name(parser_->app.add_option(name, value, help)->type_name(type)->required(), type);
}

void CommandLine::not_required_with(const std::string& name, const std::string& option) {
  parser_->not_required_with.emplace_back(name, option);
}

void CommandLine::add_integer(const std::string& name, std::int64_t& value, std::int64_t least,
                              std::int64_t most, const std::string& help, const char* fallback) {
  const auto parse = [name, least, most, &value](const std::string& text) {
    const auto number = parse_integer(text);
    if (!number || has_blanks(text) || *number < least || *number > most)
      refuse(name, wording(least, most), text);
    value = *number;
  };
  const std::string shown = fallback != nullptr ? fallback : std::to_string(value);
  add_parsed(parser_->app, name, "N", shown, help, parse);
}

void CommandLine::add_optional_text(const std::string& name, bool& is_asked, std::string& value,
                                    const std::string& type, const std::string& fallback,
                                    const std::string& help) {
  const auto parse = [&is_asked, &value](const std::vector<std::string>& texts) {
    is_asked = true;
    for (const std::string& text : texts)
      if (!text.empty()) value = text;
  };
  parser_->app.add_option_function<std::vector<std::string>>(name, parse, help)
      ->type_name("[" + type + "]")
      ->expected(0, 1)
      ->default_str(fallback);
}

void CommandLine::add_seed(const std::string& name, std::uint64_t& value, const std::string& help) {
  const auto parse = [name, &value](const std::string& text) {
    const char* end = text.data() + text.size();
    const auto [stop, code] = std::from_chars(text.data(), end, value);
    if (text.empty() || stop != end || code != std::errc{})
      refuse(name, "a whole number from 0 to 18446744073709551615", text);
  };
  add_parsed(parser_->app, name, "N", std::to_string(value), help, parse);
}

void CommandLine::add_real(const std::string& name, double& value, Range range,
                           const std::string& help, const char* fallback) {
  const auto parse = [name, range, &value](const std::string& text) {
    value = real_of(name, range, text);
  };
  const std::string shown = fallback != nullptr ? fallback : fmt::format("{}", value);
  add_parsed(parser_->app, name, "X", shown, help, parse);
}

void CommandLine::add_names(const std::string& name, std::vector<std::string>& values,
                            const std::string& fallback, const std::string& help) {
  parser_->app.add_option(name, values, help)
      ->type_name("NAMES")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->default_str(fallback);
}

void CommandLine::add_groups(const std::string& name, std::vector<std::vector<std::string>>& values,
                             std::size_t size, const std::string& type, const std::string& help) {
  parser_->app.add_option(name, values, help)
      ->type_size(static_cast<int>(size))
      ->expected(1, 1'000'000)
      ->allow_extra_args(false)
      ->type_name(type)
      ->default_str("none");
}

void CommandLine::add_reals(const std::string& name, std::vector<double>& values, Range range,
                            const std::string& fallback, const std::string& help) {
  const auto parse = [name, range, &values](const std::vector<std::string>& texts) {
    values.clear();
    for (const std::string& text : texts) values.push_back(real_of(name, range, text));
  };
  parser_->app.add_option_function<std::vector<std::string>>(name, parse, help)
      ->type_name("NUMBERS")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->default_str(fallback);
}

void CommandLine::add_choice(const std::string& name, std::string& value,
                             const std::vector<std::string_view>& names, const std::string& help) {
  const auto parse = [name, names, &value](const std::string& text) {
    for (std::string_view known : names)
      if (known == text) {
        value = text;
        return;
      }
    throw CLI::ValidationError(name, unknown_choice("choice", text, names));
  };
  add_parsed(parser_->app, name, "NAME", value, help, parse);
}

int CommandLine::parse(const Arguments& arguments) {
  CLI::App& app = parser_->app;
  Arguments reversed(arguments.rbegin(), arguments.rend());
  for (const auto& [name, option] : parser_->not_required_with)
    for (const std::string& word : arguments)
      if (word == option || word.starts_with(option + "=")) app.get_option(name)->required(false);
  try {
    app.parse(reversed);
    return -1;
  } catch (const CLI::CallForHelp&) {
    fmt::print("{}", parser_->short_help());
    return exit_ok;
  } catch (const CLI::CallForAllHelp&) {
    fmt::print("{}", parser_->help());
    return exit_ok;
  } catch (const CLI::ExtrasError&) {
    fmt::print(stderr, "{}: error: {}\n", app.get_name(), unknown_options(app));
  } catch (const CLI::ParseError& error) {
    fmt::print(stderr, "{}: error: {}\n", app.get_name(), error.what());
  }
  fmt::print(stderr, "see {} --help\n", app.get_name());
  return exit_usage;
}

void CommandLine::note_given(const std::string& name) { parser_->given_elsewhere.insert(name); }

bool CommandLine::was_given(const std::string& name) const {
  if (parser_->given_elsewhere.contains(name)) return true;
  const CLI::Option* option = parser_->app.get_option_no_throw(name);
  return option != nullptr && option->count() > 0;
}

}  // namespace pliant::app
