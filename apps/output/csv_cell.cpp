// SPDX-License-Identifier: MIT
#include "output/csv_cell.hpp"

#include <string_view>

namespace pliant::app {

std::string csv_cell(const std::string& text) {
  constexpr std::string_view formula_marks = "=+-@'\t\r";
  const bool is_risky = !text.empty() && formula_marks.find(text.front()) != std::string_view::npos;
  std::string cell = is_risky ? "'" + text : text;
  if (cell.find_first_of(",\"\r\n") == std::string::npos) return cell;
  std::string quoted = "\"";
  for (const char c : cell) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

}  // namespace pliant::app
