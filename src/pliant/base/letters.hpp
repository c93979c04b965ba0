// SPDX-License-Identifier: MIT
// Letters A to Z, large and small, whatever the locale.
#pragma once

#include <string>
#include <string_view>

namespace pliant {

constexpr bool is_upper(char c) { return c >= 'A' && c <= 'Z'; }
constexpr bool is_lower(char c) { return c >= 'a' && c <= 'z'; }
constexpr bool is_letter(char c) { return is_upper(c) || is_lower(c); }

/// `text` with large letters in place of small ones.
inline std::string upper_case(std::string_view text) {
  std::string large(text);
  for (char& c : large)
    if (is_lower(c)) c = static_cast<char>(c - 32);
  return large;
}

/// `text` with small letters in place of large ones.
inline std::string lower_case(std::string_view text) {
  std::string small(text);
  for (char& c : small)
    if (is_upper(c)) c = static_cast<char>(c + 32);
  return small;
}

}  // namespace pliant
