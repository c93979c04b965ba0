// SPDX-License-Identifier: MIT
#include "pliant/molecule/read/pdb/hybrid36.hpp"

#include <algorithm>
#include <charconv>

#include "pliant/base/letters.hpp"
#include "pliant/base/number.hpp"

namespace pliant {
namespace {

std::optional<std::int64_t> parse_in_base(std::string_view text, int base) {
  std::int64_t value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, code] = std::from_chars(text.data(), end, value, base);
  if (text.empty() || text[0] == '-' || code != std::errc{} || stop != end) return std::nullopt;
  return value;
}

std::int64_t power(std::int64_t base, std::size_t exponent) {
  std::int64_t value = 1;
  while (exponent-- > 0) value *= base;
  return value;
}

template <class Letter>
bool all_digits_or(std::string_view text, Letter is_letter) {
  return std::all_of(text.begin(), text.end(), [&](char c) { return is_digit(c) || is_letter(c); });
}

}  // namespace

std::optional<std::int64_t> parse_hybrid36(std::string_view field) {
  if (field.empty() || is_digit(field.back())) {
    if (const auto decimal = parse_integer(field)) return decimal;
  }
  if (field.empty() || field.size() > 8) return std::nullopt;
  const bool upper = is_upper(field[0]) && all_digits_or(field, is_upper);
  const bool lower = is_lower(field[0]) && all_digits_or(field, is_lower);
  if (!upper && !lower) return parse_integer(field);
  // The first letter, worth 10, continues after the last decimal number; 26 letters come before a.
  const std::int64_t digit = power(36, field.size() - 1);
  const std::int64_t first = power(10, field.size()) + (lower ? 26 * digit : 0);
  return *parse_in_base(field, 36) - 10 * digit + first;
}

std::optional<std::int64_t> parse_vmd_hexadecimal(std::string_view field) {
  field = trimmed(field);
  if (field.empty() || !is_digit(field[0])) return std::nullopt;
  if (std::all_of(field.begin(), field.end(), is_digit)) return std::nullopt;
  return parse_in_base(field, 16);
}

std::optional<std::int64_t> parse_hexadecimal(std::string_view field) {
  return parse_in_base(trimmed(field), 16);
}

}  // namespace pliant
