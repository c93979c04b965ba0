// SPDX-License-Identifier: MIT
#include "pliant/base/number.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace pliant {
namespace {

/// from_chars takes "inf" and "nan", and no leading '+': look at the first characters ourselves.
bool starts_number(std::string_view text) {
  if (text.empty()) return false;
  if (text[0] == '-') text.remove_prefix(1);
  return !text.empty() && (is_digit(text[0]) || text[0] == '.');
}

std::string_view without_plus(std::string_view text) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  return text;
}

std::optional<double> parse_plain_real(std::string_view text) {
  double value = 0.0;
  const char* end = text.data() + text.size();
  const auto [stop, code] = std::from_chars(text.data(), end, value);
  if (code != std::errc{} || stop != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// Fortran writes the exponent of a double with D.
std::optional<double> parse_fortran_real(std::string_view text) {
  std::array<char, 64> copy;
  if (text.size() > copy.size()) return std::nullopt;
  std::transform(text.begin(), text.end(), copy.begin(),
                 [](char c) { return c == 'D' || c == 'd' ? 'e' : c; });
  return parse_plain_real({copy.data(), text.size()});
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

std::optional<double> parse_real(std::string_view text) {
  text = without_plus(trimmed(text));
  if (!starts_number(text)) return std::nullopt;
  const bool fortran = text.find_first_of("dD") != std::string_view::npos;
  return fortran ? parse_fortran_real(text) : parse_plain_real(text);
}

std::optional<std::int64_t> parse_integer(std::string_view text) {
  text = without_plus(trimmed(text));
  std::int64_t value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, code] = std::from_chars(text.data(), end, value);
  if (text.empty() || code != std::errc{} || stop != end) return std::nullopt;
  return value;
}

std::string number_text(double value, int digits) {
  std::array<char, 64> text;
  const auto written = std::to_chars(text.data(), text.data() + text.size(), value,
                                     std::chars_format::general, std::min(digits, 40));
  return {text.data(), written.ptr};
}

std::string shortest_text(double value) {
  std::array<char, 32> text;
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

}  // namespace pliant
