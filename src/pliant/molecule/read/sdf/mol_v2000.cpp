// SPDX-License-Identifier: MIT
// The V2000 connection table of MDL molfiles: fixed columns.
#include "pliant/molecule/read/sdf/mol_v2000.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "pliant/base/elements.hpp"
#include "pliant/base/number.hpp"
#include "pliant/molecule/read/shared/fixed_columns.hpp"
#include "pliant/molecule/read/shared/reading.hpp"

namespace pliant {
namespace {

std::string of_total(std::string_view noun, std::size_t index, std::size_t total) {
  return std::string(noun) + " " + std::to_string(index + 1) + " of " + std::to_string(total);
}

struct CoordinateColumns {
  std::size_t first, last;
  std::string_view name;
};
constexpr std::array<CoordinateColumns, 3> coordinate_columns{
    {{1, 10, "x (columns 1-10)"}, {11, 20, "y (columns 11-20)"}, {21, 30, "z (columns 21-30)"}}};

double coordinate(std::string_view line, const CoordinateColumns& field, const Place& place,
                  std::size_t atom, std::size_t total) {
  const std::string_view text = columns(line, field.first, field.last);
  const auto value = parse_real(text);
  if (value && *value >= -largest_coordinate && *value <= largest_coordinate) return *value;
  return parse_coordinate(text, place,
                          of_total("atom", atom, total) + ": " + std::string(field.name));
}

/// What the atom line's code stands for: 1 is a charge of 3+, 7 of 3-, 4 a doublet radical.
void take_charge_code(std::string_view line, std::size_t atom, std::size_t number,
                      MolBlock& block) {
  const auto code = parse_integer(columns(line, 37, 39));
  if (!code || *code < 1 || *code > 7) return;
  if (*code == 4) block.set_radical(atom, 2, number);
  if (*code != 4) block.set_charge(atom, 4 - *code, number);
}

/// The atom line's difference, from -3 to 4, to the mass number of the element.
void take_mass_difference(std::string_view line, std::size_t atom, std::size_t number,
                          MolBlock& block) {
  const auto difference = parse_integer(columns(line, 35, 36));
  if (!difference || *difference == 0 || *difference < -3 || *difference > 4) return;
  if (block.element(atom) == 0) return;
  const auto mass = std::lround(element_mass(block.element(atom)));
  block.set_isotope(atom, mass + *difference, number);
}

void read_atom(const Lines& lines, std::size_t index, std::size_t total, MolBlock& block) {
  const std::string_view line = lines.line();
  const Place place = block.remarks().place(lines.number());
  const Vec3 position{coordinate(line, coordinate_columns[0], place, index, total),
                      coordinate(line, coordinate_columns[1], place, index, total),
                      coordinate(line, coordinate_columns[2], place, index, total)};
  const std::string_view symbol = trimmed(columns(line, 32, 34));
  if (symbol.empty())
    fail(place, of_total("atom", index, total) + ": symbol (columns 32-34) is blank");
  block.add_atom(symbol, position, static_cast<std::int64_t>(index + 1), lines.number());
  take_charge_code(line, index, lines.number(), block);
  take_mass_difference(line, index, lines.number(), block);
}

/// A whole number in three columns of a bond line.
std::int64_t bond_field(const Lines& lines, std::size_t first, std::string_view bond,
                        const Remarks& remarks) {
  const std::string_view text = columns(lines.line(), first, first + 2);
  if (const auto number = parse_integer(text)) return *number;
  fail(remarks.place(lines.number()), std::string(bond) + ": columns " + std::to_string(first) +
                                          "-" + std::to_string(first + 2) + " " + quoted(text) +
                                          " are not a whole number");
}

void read_bond(const Lines& lines, std::size_t index, std::size_t total, MolBlock& block) {
  const std::string bond = of_total("bond", index, total);
  std::array<std::size_t, 2> atoms{};
  for (std::size_t k = 0; k < 2; ++k) {
    const std::int64_t atom = bond_field(lines, 1 + 3 * k, bond, block.remarks());
    if (atom < 1 || static_cast<std::size_t>(atom) > block.size())
      fail(block.remarks().place(lines.number()), bond + ": atom " + std::to_string(atom) +
                                                      " is not from 1 to " +
                                                      std::to_string(block.size()));
    atoms[k] = static_cast<std::size_t>(atom - 1);
  }
  const std::int64_t type = bond_field(lines, 7, bond, block.remarks());
  block.add_bond(atoms[0], atoms[1], type, lines.number());
}

/// A line of the property block that has pairs of an atom and a value.
struct Property {
  std::string_view begin;
  std::string_view value;  ///< in words
  void (MolBlock::*set)(std::size_t, std::int64_t, std::size_t);
};

constexpr std::array properties{
    Property{"M  CHG", "charge", &MolBlock::set_charge},
    Property{"M  RAD", "radical", &MolBlock::set_radical},
    Property{"M  ISO", "isotope", &MolBlock::set_isotope},
};

/// "M  CHGnn8 aaa vvv ...": pairs of atom and value.
void read_pairs(const Lines& lines, const Property& property, MolBlock& block) {
  const auto count = parse_integer(columns(lines.line(), 7, 9));
  for (std::int64_t k = 0; count && k < std::min<std::int64_t>(*count, 8); ++k) {
    const auto first = static_cast<std::size_t>(10 + 8 * k);
    const auto atom = parse_integer(columns(lines.line(), first, first + 3));
    const auto value = parse_integer(columns(lines.line(), first + 4, first + 7));
    if (!atom || !value || *atom < 1 || static_cast<std::size_t>(*atom) > block.size())
      fail(block.remarks().place(lines.number()),
           std::string(property.begin) + " pair " + std::to_string(k + 1) +
               " is not an atom from 1 to " + std::to_string(block.size()) + " and its " +
               std::string(property.value) + ": " +
               quoted(columns(lines.line(), first, first + 7)));
    (block.*property.set)(static_cast<std::size_t>(*atom - 1), *value, lines.number());
  }
}

/// Reads to M  END. The first M  CHG or M  RAD takes the place of all charges of the atom lines,
/// the first M  ISO that of their mass differences.
void read_properties(Lines& lines, MolBlock& block) {
  bool charges_cleared = false, isotopes_cleared = false;
  while (lines.next() && !ends_record(lines.line())) {
    if (lines.line().starts_with("M  END")) return;
    const auto property =
        std::find_if(properties.begin(), properties.end(),
                     [&](const Property& one) { return lines.line().starts_with(one.begin); });
    if (property == properties.end()) continue;
    const bool is_isotope = property->value == "isotope";
    if (is_isotope && !std::exchange(isotopes_cleared, true)) block.clear_isotopes();
    if (!is_isotope && !std::exchange(charges_cleared, true)) block.clear_charges_and_radicals();
    read_pairs(lines, *property, block);
  }
  block.remarks().warn("no end", lines.number(), [] { return "no M  END line: taken as ended"; });
}

}  // namespace

bool parse_mol_counts(std::string_view line, MolCounts& counts) {
  const auto atoms = parse_integer(columns(line, 1, 3));
  const auto bonds = parse_integer(columns(line, 4, 6));
  if (!atoms || !bonds || *atoms < 0 || *bonds < 0) return false;
  counts = {static_cast<std::size_t>(*atoms), static_cast<std::size_t>(*bonds)};
  return true;
}

void read_mol_v2000(Lines& lines, MolBlock& block) {
  MolCounts counts;
  parse_mol_counts(lines.line(), counts);
  for (std::size_t i = 0; i < counts.atoms; ++i) {
    next_record_line(lines, of_total("atom", i, counts.atoms), block.remarks());
    read_atom(lines, i, counts.atoms, block);
  }
  for (std::size_t i = 0; i < counts.bonds; ++i) {
    next_record_line(lines, of_total("bond", i, counts.bonds), block.remarks());
    read_bond(lines, i, counts.bonds, block);
  }
  read_properties(lines, block);
}

}  // namespace pliant
