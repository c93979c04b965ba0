// SPDX-License-Identifier: MIT
#include "pliant/base/option_fields.hpp"

#include <algorithm>
#include <charconv>

#include "pliant/base/choices.hpp"
#include "pliant/base/error.hpp"
#include "pliant/base/number.hpp"

namespace pliant {
namespace {

/// Checks the value at a place.
struct Check {
  const OptionFacts& facts;

  void operator()(const bool*) const {}
  void operator()(const std::uint64_t*) const {}
  void operator()(const std::int64_t* value) const { check_range(facts.name, *value, facts.range); }
  void operator()(const double* value) const {
    if (!(facts.is_optional && *value == 0.0)) check_range(facts.name, *value, facts.range);
  }
  void operator()(const std::string* value) const {
    const std::vector<std::string_view> known = facts.choices();
    if (std::find(known.begin(), known.end(), *value) == known.end())
      throw OptionError(unknown_choice(facts.kind, *value, known));
  }
};

/// Whether all of a text is a number, which is then in `place`.
bool read_seed(std::string_view text, std::uint64_t& place) {
  const char* end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, place);
  return read.ec == std::errc() && read.ptr == end;
}

/// Puts what a text says into a place.
struct Told {
  std::string_view name, text;

  [[noreturn]] void refuse(const char* expected) const {
    throw OptionError(std::string(name) + ": expected " + expected + ", found " + quoted(text));
  }
  void operator()(bool* place) const {
    if (text != "true" && text != "false") refuse("true or false");
    *place = text == "true";
  }
  void operator()(std::int64_t* place) const {
    const auto value = parse_integer(text);
    if (!value) refuse("a whole number");
    *place = *value;
  }
  void operator()(std::uint64_t* place) const {
    if (!read_seed(text, *place)) refuse("a whole number from 0");
  }
  void operator()(double* place) const {
    const auto value = parse_real(text);
    if (!value) refuse("a number");
    *place = *value;
  }
  void operator()(std::string* place) const { *place = text; }
};

/// The text of a value.
struct Spelled {
  std::string operator()(const bool* value) const { return *value ? "true" : "false"; }
  std::string operator()(const double* value) const { return shortest_text(*value); }
  std::string operator()(const std::string* value) const { return *value; }
  std::string operator()(const auto* value) const { return std::to_string(*value); }
};

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

void check_option(const OptionFacts& facts, OptionPlace place) { std::visit(Check{facts}, place); }

void set_option(const OptionFacts& facts, OptionPlace place, std::string_view text) {
  std::visit(Told{facts.name, text}, place);
}

std::string option_text(OptionPlace place) { return std::visit(Spelled{}, place); }

Parameter parameter_of(OptionPlace place) { return std::visit(Recorded{}, place); }

const Parameter& find_parameter(const std::vector<NamedParameter>& parameters,
                                const std::string& path) {
  const auto found = std::find_if(parameters.begin(), parameters.end(),
                                  [&](const NamedParameter& one) { return one.first == path; });
  if (found == parameters.end()) throw InputError("does not say /parameters/" + path);
  return found->second;
}

void restore_option(const std::vector<NamedParameter>& parameters, const std::string& path,
                    OptionPlace place) {
  std::visit(Restored{path, find_parameter(parameters, path)}, place);
}

}  // namespace pliant
