// SPDX-License-Identifier: MIT
#include "pliant/base/option_fields.hpp"

#include <algorithm>
#include <charconv>

#include "pliant/base/choices.hpp"
#include "pliant/base/error.hpp"
#include "pliant/base/number.hpp"
#include "pliant/base/value_text.hpp"

namespace pliant {
namespace {

/// Checks the value at a place.
struct Check {
  const OptionFacts& facts;

  void operator()(const bool*) const {}
  void operator()(const std::uint64_t*) const {}
  void operator()(const std::int64_t* value) const { check_number(*value); }
  void operator()(const double* value) const {
    if (!(facts.is_optional && *value == 0.0)) check_number(*value);
  }
  void operator()(const std::string* value) const {
    if (facts.choices == nullptr) return;
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
  template <class T>
  void operator()(T* place) const {
    if (!std::holds_alternative<T>(value)) refuse();
    *place = std::get<T>(value);
  }
};

}  // namespace

std::int64_t largest_taken(const OptionFacts& facts) {
  const bool is_bounded = facts.largest < static_cast<double>(facts.most);
  return is_bounded ? static_cast<std::int64_t>(facts.largest) : facts.most;
}

void check_option(const OptionFacts& facts, OptionPlace place) { std::visit(Check{facts}, place); }

void set_option(const OptionFacts& facts, OptionPlace place, std::string_view text) {
  std::visit([&](auto* value) { set_value(facts.name, text, *value); }, place);
}

std::string option_text(OptionPlace place) {
  return std::visit([](const auto* value) { return value_text(*value); }, place);
}

Parameter parameter_of(OptionPlace place) { return std::visit(Recorded{}, place); }

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
