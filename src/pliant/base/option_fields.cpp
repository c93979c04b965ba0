// SPDX-License-Identifier: MIT
#include "pliant/base/option_fields.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>

#include "pliant/base/choices.hpp"
#include "pliant/base/error.hpp"
#include "pliant/base/number.hpp"
#include "pliant/base/value_text.hpp"

namespace pliant {
namespace {

constexpr char separators[] = {'/', static_cast<char>(std::filesystem::path::preferred_separator),
                               '\0'};

/// Checks the value at a place.
struct Check {
  const OptionFacts& facts;

  void operator()(const bool*) const {}
  void operator()(const std::uint64_t*) const {}
  void operator()(const std::int64_t* value) const {
    if (!(facts.is_optional && *value == 0)) check_number(*value);
  }
  void operator()(const double* value) const {
    if (!(facts.is_optional && *value == 0.0)) check_number(*value);
  }
  void operator()(const OptionGroups*) const {}
  void operator()(const OptionNames*) const {}
  void operator()(const std::string* value) const {
    const bool is_open = value->empty() ? facts.is_optional : *value == facts.automatic;
    if (facts.choices == nullptr || is_open) return;
    const std::vector<std::string_view> known = facts.choices();
    if (std::find(known.begin(), known.end(), *value) == known.end())
      throw OptionError(unknown_choice(facts.kind, *value, known));
  }

 private:
  void check_number(auto value) const {
    check_range(facts.name, value, facts.range);
    if (!(double(value) > facts.largest)) return;
    const std::string unit = facts.unit.empty() ? "" : " " + std::string(facts.unit);
    throw OptionError(std::string(facts.name) + " = " + value_text(value) + ": must be at most " +
                      number_text(facts.largest) + unit);
  }
};

/// Whether all of a text is a number, which is then in `place`.
bool read_seed(std::string_view text, std::uint64_t& place) {
  const char* end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, place);
  return read.ec == std::errc() && read.ptr == end;
}

/// The value at a place, as files keep it.
struct Recorded {
  Parameter operator()(const std::uint64_t* value) const { return std::to_string(*value); }
  Parameter operator()(const OptionNames* value) const { return value_text(*value); }
  Parameter operator()(const OptionGroups* value) const { return value_text(*value); }
  Parameter operator()(const auto* value) const { return *value; }
};

/// Puts a recorded value into a place.
struct Restored {
  const std::string& path;
  const Parameter& value;

  [[noreturn]] void refuse() const {
    throw InputError("/parameters/" + path + " has an invalid value");
  }
  void operator()(std::uint64_t* place) const {
    const auto* text = std::get_if<std::string>(&value);
    if (text == nullptr || !read_seed(*text, *place)) refuse();
  }
  void operator()(OptionGroups*) const {}  // as text they cannot be told apart again
  void operator()(OptionNames* place) const {
    const auto* text = std::get_if<std::string>(&value);
    if (text == nullptr) refuse();
    set_value(path, *text, *place);
  }
  template <class T>
  void operator()(T* place) const {
    if (!std::holds_alternative<T>(value)) refuse();
    *place = std::get<T>(value);
  }
};

}  // namespace

std::string option_name(std::string_view field, std::string_view dashes) {
  std::string option = std::string(dashes) + std::string(field);
  if (!dashes.empty()) std::ranges::replace(option, '_', '-');
  return option;
}

std::string option_name(const OptionFacts& facts) {
  return option_name(facts.opposite.empty() ? facts.name : facts.opposite);
}

std::int64_t least_taken(const OptionFacts& facts) {
  if (facts.least > 0) return facts.least;
  return facts.range == Range::positive ? 1 : 0;
}

std::int64_t largest_taken(const OptionFacts& facts) {
  const bool is_bounded = facts.largest < static_cast<double>(facts.most);
  return is_bounded ? static_cast<std::int64_t>(facts.largest) : facts.most;
}

void check_option(const OptionFacts& facts, OptionPlace place) { std::visit(Check{facts}, place); }

void set_option(const OptionFacts& facts, OptionPlace place, std::string_view text) {
  std::visit(
      [&](auto* value) {
        if constexpr (std::is_same_v<decltype(value), OptionGroups*>)
          throw OptionError(std::string(facts.name) + ": is not set from one text");
        else
          set_value(facts.name, text, *value);
      },
      place);
}

std::string option_text(OptionPlace place) {
  return std::visit([](const auto* value) { return value_text(*value); }, place);
}

Parameter parameter_of(const OptionFacts& facts, OptionPlace place) {
  Parameter value = std::visit(Recorded{}, place);
  if (auto* text = std::get_if<std::string>(&value); facts.is_file && text != nullptr)
    *text = text->substr(text->find_last_of(separators) + 1);
  return value;
}

std::string recorded_path(std::string_view group, const OptionFacts& facts) {
  if (!facts.recorded.empty()) return std::string(facts.recorded);
  return std::string(group) + "/" + std::string(facts.name);
}

bool has_parameter(const std::vector<NamedParameter>& parameters, const std::string& path) {
  return std::ranges::find(parameters, path, &NamedParameter::first) != parameters.end();
}

const Parameter& find_parameter(const std::vector<NamedParameter>& parameters,
                                const std::string& path) {
  const auto found = std::ranges::find(parameters, path, &NamedParameter::first);
  if (found == parameters.end()) throw InputError("does not say /parameters/" + path);
  return found->second;
}

void restore_option(const std::vector<NamedParameter>& parameters, const std::string& path,
                    OptionPlace place) {
  std::visit(Restored{path, find_parameter(parameters, path)}, place);
}

}  // namespace pliant
