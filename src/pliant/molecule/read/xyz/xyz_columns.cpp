// SPDX-License-Identifier: MIT
#include "pliant/molecule/read/xyz/xyz_columns.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "pliant/base/error.hpp"
#include "pliant/base/number.hpp"

namespace pliant {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t'; }

/// Cuts "key", "key=bare" or "key="quoted value"" off the front of `rest`.
/// Nothing where a quote is not closed.
std::optional<std::string_view> next_word(std::string_view& rest) {
  rest = trimmed(rest);
  char quote = 0;
  std::size_t end = 0;
  for (; end < rest.size() && (quote != 0 || !is_blank(rest[end])); ++end) {
    const char c = rest[end];
    if (quote != 0 && c == '\\') {
      ++end;
    } else if (quote != 0) {
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    }
  }
  if (quote != 0) return std::nullopt;
  const std::string_view word = rest.substr(0, end);
  rest.remove_prefix(word.size());
  return word;
}

std::string_view unquoted(std::string_view value) {
  if (value.size() >= 2 && (value[0] == '"' || value[0] == '\'') && value.back() == value[0])
    return value.substr(1, value.size() - 2);
  return value;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find(separator, start), text.size());
    parts.push_back(text.substr(start, end - start));
    start = end + 1;
  }
  return parts;
}

/// "species:S:1:pos:R:3": triples of name, type (S, R, I, L) and number of columns.
std::optional<XyzColumns> columns_of(std::string_view properties) {
  const auto parts = split(properties, ':');
  if (parts.size() % 3 != 0) return std::nullopt;
  std::optional<std::size_t> symbol, number, position;
  std::size_t column = 0;
  for (std::size_t i = 0; i < parts.size(); i += 3) {
    const auto count = parse_integer(parts[i + 2]);
    if (!count || *count < 1 || *count > 10000) return std::nullopt;
    if (parts[i] == "species" && *count == 1) symbol = column;
    if (parts[i] == "Z" && *count == 1) number = column;
    if (parts[i] == "pos" && parts[i + 1] == "R" && *count == 3) position = column;
    column += static_cast<std::size_t>(*count);
  }
  if (!symbol) symbol = number;
  if (!symbol || !position) return std::nullopt;
  return XyzColumns{*symbol, *position, column};
}

bool looks_extended(std::string_view comment) {
  return comment.find("Properties=") != std::string_view::npos ||
         comment.find("Lattice=") != std::string_view::npos;
}

/// The value of a key of the comment, without quotes; nothing where the key is not there.
std::optional<std::string_view> value_of(std::string_view comment, std::string_view key) {
  for (std::string_view rest = comment; !trimmed(rest).empty();) {
    const auto word = next_word(rest);
    if (!word) return std::nullopt;
    if (word->starts_with(key)) return unquoted(word->substr(key.size()));
  }
  return std::nullopt;
}

/// The words between blanks, commas and brackets.
std::vector<std::string_view> words_of(std::string_view text) {
  constexpr std::string_view between = " \t,[]";
  std::vector<std::string_view> words;
  while (true) {
    text.remove_prefix(std::min(text.find_first_not_of(between), text.size()));
    if (text.empty()) return words;
    words.push_back(text.substr(0, text.find_first_of(between)));
    text.remove_prefix(words.back().size());
  }
}

bool is_true(std::string_view word) {
  return word.starts_with('T') || word.starts_with('t') || word == "1";
}

/// Nine numbers, or nothing.
std::optional<std::array<double, 9>> nine_numbers(std::string_view text) {
  const auto words = words_of(text);
  std::array<double, 9> numbers{};
  if (words.size() != numbers.size()) return std::nullopt;
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    const auto number = parse_real(words[k]);
    if (!number) return std::nullopt;
    numbers[k] = *number;
  }
  return numbers;
}

}  // namespace

std::optional<Cell> cell_of_comment(std::string_view comment, std::string& problem) {
  const auto lattice = value_of(comment, "Lattice=");
  if (!lattice) return std::nullopt;
  const auto numbers = nine_numbers(*lattice);
  if (!numbers) problem = "Lattice " + quoted(*lattice) + " is not nine numbers";
  const auto flags = words_of(value_of(comment, "pbc=").value_or(""));
  if (!numbers || !std::all_of(flags.begin(), flags.end(), is_true)) return std::nullopt;
  const auto& n = *numbers;
  return cell_of(std::array<Vec3, 3>{{{n[0], n[1], n[2]}, {n[3], n[4], n[5]}, {n[6], n[7], n[8]}}});
}

XyzColumns columns_of_comment(std::string_view comment, std::string& problem) {
  if (!looks_extended(comment)) return {};
  constexpr std::string_view key = "Properties=";
  for (std::string_view rest = comment; !trimmed(rest).empty();) {
    const auto word = next_word(rest);
    if (!word) {
      problem = "a quote in the comment is not closed";
      return {};
    }
    if (!word->starts_with(key)) continue;
    const std::string_view value = unquoted(word->substr(key.size()));
    if (const auto columns = columns_of(value)) return *columns;
    problem = "Properties " + quoted(value) + " does not name columns for species and pos:R:3";
    return {};
  }
  return {};
}

}  // namespace pliant
