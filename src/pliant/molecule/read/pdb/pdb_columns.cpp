// SPDX-License-Identifier: MIT
#include "pliant/molecule/read/pdb/pdb_columns.hpp"

#include <algorithm>
#include <array>

#include "pliant/base/number.hpp"
#include "pliant/molecule/read/pdb/hybrid36.hpp"
#include "pliant/molecule/read/shared/element_of_name.hpp"
#include "pliant/molecule/read/shared/reading.hpp"

namespace pliant {
namespace {

bool is_blank(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return c == ' '; });
}

struct CoordinateColumns {
  std::size_t first, last;
  std::string_view name;
};
constexpr std::array<CoordinateColumns, 3> coordinate_columns{{
    {31, 38, "x (columns 31-38)"},
    {39, 46, "y (columns 39-46)"},
    {47, 54, "z (columns 47-54)"},
}};

double coordinate(const PdbLine& line, const CoordinateColumns& field, const Remarks& remarks) {
  const std::string_view text = columns(line.text, field.first, field.last);
  if (line.text.size() < field.last && !is_blank(text))
    fail(remarks.place(line.number), std::string(field.name) + " " + quoted(text) +
                                         " is cut short: the line ends in column " +
                                         std::to_string(line.text.size()));
  return parse_coordinate(text, remarks.place(line.number), field.name);
}

void refuse_tabs(const PdbLine& line, const Remarks& remarks) {
  const std::size_t tab = line.text.substr(0, 54).find('\t');
  if (tab == std::string_view::npos) return;
  fail(remarks.place(line.number), "a tab in column " + std::to_string(tab + 1) +
                                       ": PDB records have fixed columns, filled with blanks");
}

/// Whether the decimal points of x, y and z stand where a PDB file has them.
bool has_points_in_place(std::string_view line) {
  return column(line, 35) == '.' && column(line, 43) == '.' && column(line, 51) == '.';
}

/// A six-digit serial number either uses the free column 12 (then all is in its place) or has
/// pushed the rest of the line to the right. Decimal points tell which.
void refuse_shift_by_serial(const PdbLine& line, Remarks const& remarks) {
  const bool runs_over = is_digit(column(line.text, 12)) && is_digit(column(line.text, 11));
  if (!runs_over || has_points_in_place(line.text)) return;
  fail(remarks.place(line.number),
       "serial number (columns 7-11) runs on into column 12: " + quoted(columns(line.text, 7, 12)) +
           " has shifted the columns after it");
}

/// The digits of a number that runs from column 23 over the insertion code, or "".
std::string_view overlong_residue_number(std::string_view line) {
  const std::string_view field = columns(line, 23, 30);
  const auto stop = std::find_if_not(field.begin(), field.end(), is_digit);
  const auto digits = static_cast<std::size_t>(stop - field.begin());
  return digits > 4 ? field.substr(0, digits) : std::string_view();
}

/// A residue number of five digits either uses the free column 27, or has pushed the rest of the
/// line to the right.
void refuse_shift_by_residue_number(const PdbLine& line, const Remarks& remarks) {
  const std::string_view number = overlong_residue_number(line.text);
  if (number.empty() || has_points_in_place(line.text)) return;
  fail(remarks.place(line.number), "residue number (columns 23-26) runs on into column " +
                                       std::to_string(22 + number.size()) + ": " + quoted(number) +
                                       " has shifted the columns after it");
}

std::int64_t residue_number(const PdbLine& line, const Residue& previous, Remarks& remarks) {
  const std::string_view field = columns(line.text, 23, 26);
  if (const auto number = parse_hybrid36(field)) return *number;
  if (is_blank(field)) {
    remarks.warn("blank residue number", line.number,
                 [] { return "residue number (columns 23-26) is blank: taken as 1"; });
    return 1;
  }
  if (field == "****") {
    remarks.warn("starred residue number", line.number, [] {
      return "residue number (columns 23-26) has overflowed to ****: the residue gets the next "
             "number";
    });
    return previous.number + 1;
  }
  if (const auto number = parse_vmd_hexadecimal(field)) {
    remarks.warn("hexadecimal residue number", line.number, [&] {
      return "residue number (columns 23-26) " + quoted(field) + " is read as hexadecimal";
    });
    return *number;
  }
  fail(remarks.place(line.number),
       "residue number (columns 23-26) " + quoted(field) + " is not a number");
}

void take_number(const PdbLine& line, const Residue& previous, Residue& residue, Remarks& remarks) {
  const std::string_view overlong = overlong_residue_number(line.text);
  if (overlong.empty()) {
    residue.number = residue_number(line, previous, remarks);
    residue.insertion_code = column(line.text, 27);
    return;
  }
  residue.number = *parse_integer(overlong);
  remarks.warn("overlong residue number", line.number, [&] {
    return "residue number " + std::string(overlong) +
           " runs over the insertion code (column 27): taken as the number";
  });
}

}  // namespace

Vec3 pdb_position(const PdbLine& line, const Remarks& remarks) {
  refuse_tabs(line, remarks);
  refuse_shift_by_serial(line, remarks);
  refuse_shift_by_residue_number(line, remarks);
  return {coordinate(line, coordinate_columns[0], remarks),
          coordinate(line, coordinate_columns[1], remarks),
          coordinate(line, coordinate_columns[2], remarks)};
}

bool has_starred_residue(std::string_view line) { return columns(line, 23, 26) == "****"; }

PdbNames pdb_names(std::string_view line, std::size_t first) {
  const std::string_view three = trimmed(columns(line, first, first + 2));
  const std::string_view four = trimmed(columns(line, first, first + 3));
  const bool longer =
      column(line, first + 3) != ' ' && (is_long_residue_name(four) || !is_standard_residue(three));
  return {longer ? four : three, trimmed(columns(line, first + (longer ? 4 : 3), first + 4))};
}

Residue pdb_residue(const PdbLine& line, const Residue& previous, Remarks& remarks) {
  const PdbNames names = pdb_names(line.text, 18);
  Residue residue;
  residue.name = names.residue.empty() ? "UNK" : names.residue;
  residue.chain = names.chain;
  take_number(line, previous, residue, remarks);
  return residue;
}

std::string_view pdb_segment(std::string_view line) {
  const std::string_view field = trimmed(columns(line, 73, 76));
  const auto fits = [](char c) { return c > ' ' && c < '\x7f' && c != '.' && c != ','; };
  const bool runs_in = is_digit(column(line, 72)) || column(line, 72) == '.';
  return !runs_in && std::all_of(field.begin(), field.end(), fits) ? field : std::string_view();
}

float pdb_occupancy(const PdbLine& line, Remarks& remarks) {
  const std::string_view occupancy = columns(line.text, 55, 60);
  const std::string_view b_factor = columns(line.text, 61, 66);
  const auto value = parse_real(occupancy);
  const bool bad_occupancy = !value && !is_blank(occupancy);
  if (bad_occupancy || (!is_blank(b_factor) && !parse_real(b_factor)))
    remarks.warn("occupancy", line.number, [&] {
      return std::string(bad_occupancy ? "occupancy (columns 55-60) "
                                       : "B factor (columns 61-66) ") +
             quoted(bad_occupancy ? occupancy : b_factor) + " is not a number: left out";
    });
  return value ? static_cast<float>(*value) : 1.0F;
}

float pdb_b_factor(const PdbLine& line) {
  return static_cast<float>(parse_real(columns(line.text, 61, 66)).value_or(0.0));
}

std::int8_t pdb_charge(const PdbLine& line, Remarks& remarks) {
  char digit = column(line.text, 79), sign = column(line.text, 80);
  if (digit == ' ' && sign == ' ') return 0;
  if (is_digit(sign)) std::swap(digit, sign);
  if (digit == '0') return 0;
  if (is_digit(digit) && (sign == '+' || sign == '-'))
    return static_cast<std::int8_t>(sign == '-' ? '0' - digit : digit - '0');
  remarks.warn("charge", line.number, [&] {
    return "charge (columns 79-80) " + quoted(columns(line.text, 79, 80)) +
           " is not like 2+ or 1-: taken as 0";
  });
  return 0;
}

}  // namespace pliant
