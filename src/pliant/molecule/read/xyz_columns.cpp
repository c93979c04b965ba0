// SPDX-License-Identifier: MIT
#include "pliant/molecule/read/xyz_columns.hpp"

#include <algorithm>
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

}  // namespace

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
