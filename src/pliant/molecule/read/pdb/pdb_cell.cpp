// SPDX-License-Identifier: MIT
#include "pliant/molecule/read/pdb/pdb_cell.hpp"

#include <array>

#include "pliant/base/number.hpp"
#include "pliant/text/text_lines.hpp"

namespace pliant {
namespace {

struct CellColumns {
  std::size_t first, last;
};
constexpr std::array<CellColumns, 6> cell_columns{
    {{7, 15}, {16, 24}, {25, 33}, {34, 40}, {41, 47}, {48, 54}}};

}  // namespace

std::optional<Cell> pdb_cell(const PdbLine& line, Remarks& remarks) {
  if (trimmed(columns(line.text, 7, 54)).empty()) return std::nullopt;
  std::array<double, 6> values{};
  for (std::size_t k = 0; k < values.size(); ++k) {
    const std::string_view text =
        trimmed(columns(line.text, cell_columns[k].first, cell_columns[k].last));
    const auto value = parse_real(text);
    if (!value) {
      remarks.warn("cell", line.number, [&] {
        return "CRYST1 record: columns " + std::to_string(cell_columns[k].first) + "-" +
               std::to_string(cell_columns[k].last) + " " + quoted(text) +
               " are not a number: no periodic cell";
      });
      return std::nullopt;
    }
    values[k] = *value;
  }
  return cell_of(std::array<double, 3>{values[0], values[1], values[2]},
                 std::array<double, 3>{values[3], values[4], values[5]});
}

}  // namespace pliant
