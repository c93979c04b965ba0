// SPDX-License-Identifier: MIT
#include "pliant/base/value_text.hpp"

#include <algorithm>
#include <charconv>

#include "pliant/base/error.hpp"
#include "pliant/base/number.hpp"

namespace pliant {
namespace {

[[noreturn]] void refuse(std::string_view name, std::string_view text,
                         const std::string& expected) {
  throw OptionError(std::string(name) + ": expected " + expected + ", found " + quoted(text));
}

std::string whole_number_from(std::int64_t least) {
  const bool is_any = least == std::numeric_limits<std::int64_t>::min();
  return "a whole number" + (is_any ? "" : " from " + std::to_string(least));
}

}  // namespace

void set_value(std::string_view name, std::string_view text, bool& place) {
  if (text != "true" && text != "false") refuse(name, text, "true or false");
  place = text == "true";
}

void set_value(std::string_view name, std::string_view text, std::int64_t& place,
               std::int64_t least) {
  const auto value = parse_integer(text);
  if (!value || *value < least) refuse(name, text, whole_number_from(least));
  place = *value;
}

void set_value(std::string_view name, std::string_view text, std::uint64_t& place) {
  const char* end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, place);
  if (read.ec != std::errc() || read.ptr != end) refuse(name, text, whole_number_from(0));
}

void set_value(std::string_view name, std::string_view text, double& place) {
  const auto value = parse_real(text);
  if (!value) refuse(name, text, "a number");
  place = *value;
}

void set_value(std::string_view, std::string_view text, std::string& place) { place = text; }

void set_value(std::string_view, std::string_view text, std::vector<std::string>& place) {
  place.clear();
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t comma = std::min(text.find(',', from), text.size());
    place.emplace_back(text.substr(from, comma - from));
    from = comma + 1;
  }
}

std::string value_text(bool value) { return value ? "true" : "false"; }
std::string value_text(std::int64_t value) { return std::to_string(value); }
std::string value_text(std::uint64_t value) { return std::to_string(value); }
std::string value_text(double value) { return shortest_text(value); }
std::string value_text(const std::string& value) { return value; }

std::string value_text(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ",") + name;
  return text;
}

std::string value_text(const std::vector<std::vector<std::string>>& groups) {
  std::string text;
  for (const auto& words : groups)
    for (const std::string& word : words) text += (text.empty() ? "" : " | ") + word;
  return text;
}

}  // namespace pliant
