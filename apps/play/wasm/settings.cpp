// SPDX-License-Identifier: MIT
#include "settings.hpp"

#include <charconv>
#include <cmath>
#include <utility>

#include "pliant/base/error.hpp"

namespace pliant::play {
namespace {

[[noreturn]] void refuse(const OptionFacts& field, const Json& value, const char* expected) {
  throw OptionError(std::string(field.name) + " = " + value.dump() + ": expected " + expected);
}

/// Puts a JSON value into the place of a setting.
struct Put {
  const OptionFacts& field;
  const Json& value;

  void operator()(bool* place) const {
    if (!value.is_boolean()) refuse(field, value, "true or false");
    *place = value.get<bool>();
  }
  void operator()(std::int64_t* place) const {
    const double number = value.is_number() ? value.get<double>() : NAN;
    if (!(std::abs(number) < 9e15) || number != std::floor(number))
      refuse(field, value, "a whole number");
    *place = static_cast<std::int64_t>(number);
  }
  void operator()(std::uint64_t* place) const {
    const std::string text = value.is_string() ? value.get<std::string>() : value.dump();
    const char* end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, *place);
    if (read.ec != std::errc() || read.ptr != end) refuse(field, value, "a whole number from 0");
  }
  void operator()(double* place) const {
    if (!value.is_number()) refuse(field, value, "a number");
    *place = value.get<double>();
  }
  void operator()(OptionGroups*) const { refuse(field, value, "what the page can set"); }
  void operator()(OptionNames* place) const {
    if (!value.is_array()) refuse(field, value, "a list of names");
    *place = value.get<OptionNames>();
  }
  void operator()(std::string* place) const {
    if (!value.is_string()) refuse(field, value, "a name");
    *place = value.get<std::string>();
  }
};

struct Shown {
  Json operator()(const std::uint64_t* value) const { return std::to_string(*value); }
  Json operator()(const auto* value) const { return *value; }
};

}  // namespace

void put_option(const OptionFacts& facts, OptionPlace place, const Json& value) {
  std::visit(Put{facts, value}, place);
}

RunOptions with_settings(RunOptions options, const Json& fields) {
  return with_options(run_fields(), std::move(options), fields);
}

bool is_no_setting(const RunField& field) { return field.name == "steps" || field.name == "every"; }

Json settings_of(const RunOptions& options) {
  RunOptions copy = options;
  Json all = Json::object();
  for (const RunField& field : run_fields()) {
    if (is_no_setting(field)) continue;
    all[std::string(field.name)] = std::visit(Shown{}, field.place(copy));
  }
  return all;
}

}  // namespace pliant::play
