// SPDX-License-Identifier: MIT
#include "pliant/record/pdb_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "pliant/base/elements.hpp"
#include "pliant/base/error.hpp"
#include "pliant/record/topology_pdb.hpp"

namespace pliant {
namespace {

constexpr std::int64_t last_decimal_serial = 99'999;

// Residues of polymers are ATOM records, all others HETATM.
constexpr std::string_view polymer_residues[] = {"A",   "ALA", "ARG", "ASN", "ASP", "C",   "CYS",
                                                 "DA",  "DC",  "DG",  "DT",  "G",   "GLN", "GLU",
                                                 "GLY", "HIS", "ILE", "LEU", "LYS", "MET", "PHE",
                                                 "PRO", "SER", "THR", "TRP", "TYR", "U",   "VAL"};

std::int64_t power(std::int64_t base, std::size_t exponent) {
  std::int64_t value = 1;
  while (exponent-- > 0) value *= base;
  return value;
}

/// `number` below 36^width, with `letters` for the digits past 9.
std::string in_base36(std::int64_t number, std::size_t width, char letter_a) {
  std::string text(width, '0');
  for (std::size_t k = width; k-- > 0; number /= 36) {
    const auto digit = static_cast<char>(number % 36);
    text[k] = static_cast<char>(digit < 10 ? '0' + digit : letter_a + digit - 10);
  }
  return text;
}

/// What would end a line or shift its columns becomes '_'.
std::string printable(std::string text, char least = '!') {
  for (char& c : text)
    if (c < least || c > '~') c = '_';
  return text;
}

std::string cut(const std::string& text, std::size_t length, std::size_t& count) {
  if (text.size() > length) ++count;
  return printable(text.substr(0, length));
}

/// Symbols of one letter stand in column 14, of two in 13 and 14: " CA " is carbon, "CA  " calcium.
std::string name_columns(const std::string& name, std::uint8_t element) {
  const bool two_letters = element != 0 && element_symbol(element).size() == 2;
  return name.size() < 4 && !two_letters ? " " + name : name;
}

std::string element_columns(std::uint8_t element) {
  if (element == 0) return "";
  std::string symbol(element_symbol(element));
  std::transform(symbol.begin(), symbol.end(), symbol.begin(),
                 [](char c) { return c >= 'a' && c <= 'z' ? char(c - 'a' + 'A') : c; });
  return symbol;
}

}  // namespace

void PdbCuts::tell(const std::string& file, const Log& log) const {
  const auto warn = [&](std::size_t count, std::string_view what) {
    if (count > 0) log.warn(fmt::format("{}: {}: {}", file, what, count));
  };
  warn(atom_names, "atom names cut to four characters");
  warn(residue_names, "residue names cut to four characters");
  warn(chains, "chain names cut to one character, and to four as segments");
  warn(bonds, "bonds of atoms past 99,999 left out, as MDAnalysis stops at them");
}

void PdbText::add_title(const std::string& title) {
  if (!title.empty()) fmt::format_to(out(), "TITLE     {:.70}\n", printable(title, ' '));
}

void PdbText::add_model(std::int64_t number, std::span<const Vec3> positions) {
  fmt::format_to(out(), "MODEL {:>8}\n", number);  // the standard's columns are 11 to 14
  add_atoms(positions);
  text_ += "ENDMDL\n";
}

void PdbText::add_remark(const std::string& text) {
  fmt::format_to(out(), "REMARK   1 {:.69}\n", printable(text, ' '));
}

void PdbText::add_atoms(std::span<const Vec3> positions, std::span<const double> b_factors) {
  text_.reserve(positions.size() * 81);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const bool chain_ends = i > 0 && atoms_.residues[atoms_.residue_of[i]].chain !=
                                         atoms_.residues[atoms_.residue_of[i - 1]].chain;
    if (chain_ends) text_ += "TER\n";
    add_atom(i, positions[i], b_factors.empty() ? 0.0 : b_factors[i]);
  }
}

void PdbText::add_atom(std::size_t atom, Vec3 position, double b_factor) {
  check_position(atom, position);
  const Residue& residue = atoms_.residues[atoms_.residue_of[atom]];
  const bool polymer =
      std::binary_search(std::begin(polymer_residues), std::end(polymer_residues), residue.name);
  const std::uint8_t element = atoms_.elements[atom];
  const std::string name = cut(atoms_.names[atom], 4, cuts_.atom_names);
  const std::string residue_name = cut(residue.name, 4, cuts_.residue_names);
  if (residue.chain.size() > 1) ++cuts_.chains;
  // Columns 18-21: names of four letters take the one before the chain, too.
  fmt::format_to(
      out(), "{:<6}{} {:<4} {:<4}{:1}{}{}   {:8.3f}{:8.3f}{:8.3f}{:6.2f}{:6.2f}      {:<4}{:>2}\n",
      polymer ? "ATOM" : "HETATM", hybrid36(std::int64_t(atom) + 1, 5), name_columns(name, element),
      fmt::format("{:>3}", residue_name), printable(residue.chain.substr(0, 1)),
      number_columns(atom), residue.insertion_code > ' ' ? residue.insertion_code : ' ', position.x,
      position.y, position.z, 1.0, b_factor,
      residue.chain.size() > 1 ? printable(residue.chain.substr(0, 4)) : "",
      element_columns(element));
}

void PdbText::check_atom(std::size_t atom, Vec3 position) const {
  check_position(atom, position);
  number_columns(atom);
}

std::string PdbText::number_columns(std::size_t atom) const {
  const std::int64_t number = atoms_.residues[atoms_.residue_of[atom]].number;
  try {
    return hybrid36(number, 4);
  } catch (const InputError&) {
    throw InputError("residue number of " + atoms_.label(atom) +
                     " does not fit the columns of a PDB file (-999 to 2436111)");
  }
}

void PdbText::check_position(std::size_t atom, Vec3 position) const {
  for (const double x : {position.x, position.y, position.z}) {
    const double rounded = std::round(x * 1000.0) / 1000.0;
    if (!(rounded >= -999.999 && rounded <= 9999.999))
      throw InputError(fmt::format(
          "position of {} ({:.6g}, {:.6g}, {:.6g}) does not fit the columns of a PDB file "
          "(-999.999 to 9999.999 Angstrom)",
          atoms_.label(atom), position.x, position.y, position.z));
  }
}

std::vector<std::vector<std::uint32_t>> PdbText::neighbours(std::span<const RecordedBond> bonds) {
  std::vector<std::vector<std::uint32_t>> neighbours(atoms_.size());
  for (const RecordedBond& bond : bonds) {
    if (bond.a >= atoms_.size() || bond.b >= atoms_.size())
      throw InputError(
          fmt::format("bond of atoms {} and {}, of {} atoms", bond.a, bond.b, atoms_.size()));
    if (!hybrid36_bonds_ && std::max(bond.a, bond.b) >= last_decimal_serial) {
      ++cuts_.bonds;
      continue;
    }
    const int times = bond.order == 2 || bond.order == 3 ? bond.order : 1;
    for (int k = 0; k < times; ++k) {
      neighbours[bond.a].push_back(bond.b);
      neighbours[bond.b].push_back(bond.a);
    }
  }
  return neighbours;
}

void PdbText::add_bonds(std::span<const RecordedBond> bonds) {
  auto neighbours_of = neighbours(bonds);
  for (std::size_t i = 0; i < neighbours_of.size(); ++i) {
    std::sort(neighbours_of[i].begin(), neighbours_of[i].end());
    add_conect(i, neighbours_of[i]);
  }
}

/// A record holds four atoms.
void PdbText::add_conect(std::size_t atom, std::span<const std::uint32_t> others) {
  for (std::size_t first = 0; first < others.size(); first += 4) {
    text_ += "CONECT" + hybrid36(std::int64_t(atom) + 1, 5);
    for (const auto other : others.subspan(first, std::min<std::size_t>(4, others.size() - first)))
      text_ += hybrid36(std::int64_t{other} + 1, 5);
    text_ += '\n';
  }
}

std::string hybrid36(std::int64_t number, std::size_t width) {
  const std::int64_t decimals = power(10, width), letters = 26 * power(36, width - 1);
  if (number > -decimals / 10 && number < decimals) return fmt::format("{:>{}}", number, width);
  if (number < 0 || number >= decimals + 2 * letters)
    throw InputError(fmt::format("{} does not fit {} columns", number, width));
  const std::int64_t beyond = number - decimals, first = 10 * power(36, width - 1);
  return beyond < letters ? in_base36(beyond + first, width, 'A')
                          : in_base36(beyond - letters + first, width, 'a');
}

}  // namespace pliant
