// SPDX-License-Identifier: MIT
#include "pliant/molecule/read/shared/element_of_name.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "pliant/base/elements.hpp"
#include "pliant/base/letters.hpp"
#include "pliant/base/number.hpp"
#include "pliant/molecule/structure/atom_label.hpp"
#include "pliant/molecule/structure/residue_templates.hpp"

namespace pliant {
namespace {

// Sorted. Protonation variants are those of Amber, CHARMM and GROMOS.
constexpr auto standard_residues = std::to_array<std::string_view>({
    "A",    "ACE",  "ADE",  "ALA", "ARG",  "ARGN", "ASH", "ASN", "ASP", "ASPH", "C",    "CYM",
    "CYS",  "CYT",  "CYX",  "DA",  "DC",   "DG",   "DI",  "DOD", "DT",  "DU",   "G",    "GLH",
    "GLN",  "GLU",  "GLUH", "GLY", "GUA",  "H2O",  "HID", "HIE", "HIP", "HIS",  "HISA", "HISB",
    "HISD", "HISE", "HISH", "HOH", "HSD",  "HSE",  "HSP", "HYP", "I",   "ILE",  "LEU",  "LYN",
    "LYS",  "LYSH", "MET",  "MSE", "NH2",  "NMA",  "NME", "PHE", "PRO", "RA",   "RC",   "RG",
    "RU",   "SER",  "SOL",  "SPC", "SPCE", "T",    "THR", "THY", "TIP", "TIP3", "TIP4", "TIP5",
    "TP3",  "TRP",  "TYR",  "U",   "URA",  "VAL",  "WAT",
});
static_assert(std::is_sorted(standard_residues.begin(), standard_residues.end()));

constexpr auto waters = std::to_array<std::string_view>(
    {"DOD", "H2O", "HOH", "SOL", "SPC", "SPCE", "TIP", "TIP3", "TIP4", "TIP5", "TP3", "WAT"});
static_assert(std::is_sorted(waters.begin(), waters.end()));

/// Ions whose atom and residue names are no element symbols (CHARMM).
struct NamedIon {
  std::string_view name, symbol;
};
constexpr auto named_ions = std::to_array<NamedIon>({{"BAR", "BA"},
                                                     {"CAL", "CA"},
                                                     {"CES", "CS"},
                                                     {"CLA", "CL"},
                                                     {"LIT", "LI"},
                                                     {"POT", "K"},
                                                     {"RUB", "RB"},
                                                     {"SOD", "NA"}});

template <class Names>
bool contains(const Names& sorted, std::string_view name) {
  return std::binary_search(sorted.begin(), sorted.end(), name);
}

std::string_view without_leading_digits(std::string_view name) {
  const auto first = std::find_if_not(name.begin(), name.end(), is_digit);
  return name.substr(static_cast<std::size_t>(first - name.begin()));
}

/// "NA+" -> "NA", "ZN2" -> "ZN".
std::string_view without_charge(std::string_view name) {
  const std::size_t last = name.find_last_not_of("0123456789+-");
  return last == std::string_view::npos ? name : name.substr(0, last + 1);
}

std::uint8_t element_in_standard_residue(std::string_view name, std::string_view residue) {
  const std::string_view letters = without_leading_digits(name);
  if (letters.empty()) return 0;
  if (residue == "MSE" && letters.starts_with("SE")) return element_number("SE");
  if (contains(waters, residue) && letters[0] != 'O' && letters[0] != 'H' && letters[0] != 'D')
    return 0;  // the dummy sites of four- and five-point water: MW, EPW, LP1
  constexpr std::string_view possible = "HDCNOPS";
  return possible.find(letters[0]) == std::string_view::npos ? 0
                                                             : element_number(letters.substr(0, 1));
}

/// "Cl-" -> "CL", "SOD" -> "NA".
std::string ion_symbol(std::string_view name) {
  std::string letters = upper_case(without_charge(name));
  for (const NamedIon& ion : named_ions)
    if (ion.name == letters) return std::string(ion.symbol);
  return letters;
}

/// An atom named like its residue is an ion, however it is padded and spelt; 0 where it is not.
std::uint8_t element_of_ion(std::string_view name, std::string_view residue) {
  const std::string symbol = ion_symbol(name);
  return symbol == ion_symbol(residue) ? element_number(symbol) : std::uint8_t{0};
}

/// "Cl1" and "Br" wherever they stand, which capitals tell only by their padding.
std::uint8_t element_of_spelt_halogen(std::string_view name) {
  const bool halogen = name.starts_with("Cl") || name.starts_with("Br");
  return halogen ? element_number(name.substr(0, 2)) : std::uint8_t{0};
}

/// A name of four letters fills column 13 whatever its element: "HG11", "CL12", "C10A".
std::uint8_t element_of_padded_name(std::string_view padded) {
  if (padded[0] == ' ' || is_digit(padded[0])) return element_number(padded.substr(1, 1));
  if (!is_upper(padded[1])) return element_of_label(trimmed(padded)).element;
  if (padded[3] != ' ') return element_of_capitals(padded[0], padded[1]);
  const std::uint8_t pair = element_number(padded.substr(0, 2));
  return pair != 0 ? pair : element_number(padded.substr(0, 1));
}

using PaddedName = std::array<char, 4>;

PaddedName upper_padded(std::string_view name) {
  PaddedName padded{' ', ' ', ' ', ' '};
  const std::string letters = upper_case(name.substr(0, padded.size()));
  std::copy(letters.begin(), letters.end(), padded.begin());
  return padded;
}

/// What the residue says whatever the padding: 0 for a dummy site of water. Nothing where it says
/// nothing.
std::optional<std::uint8_t> element_by_residue(std::string_view name, std::string_view residue) {
  const bool terminal = is_long_residue_name(residue) && !is_standard_residue(residue);
  if (terminal) residue.remove_prefix(1);
  if (is_standard_residue(residue)) return element_in_standard_residue(upper_case(name), residue);
  if (const std::uint8_t ion = element_of_ion(name, residue)) return ion;
  if (const std::uint8_t halogen = element_of_spelt_halogen(name)) return halogen;
  return std::nullopt;
}

}  // namespace

bool is_standard_residue(std::string_view name) {
  return contains(standard_residues, name) || find_residue_template(name) != nullptr;
}

bool is_long_residue_name(std::string_view name) {
  if (name.size() != 4) return false;
  const bool terminal = name[0] == 'N' || name[0] == 'C';  // Amber's NALA and CALA
  return is_standard_residue(name) || (terminal && is_standard_residue(name.substr(1)));
}

std::uint8_t element_of_pdb_name(std::string_view padded_name, std::string_view residue_name) {
  const PaddedName padded = upper_padded(padded_name);
  const std::string_view text(padded.data(), padded.size());
  if (trimmed(text).empty()) return 0;
  if (const auto element = element_by_residue(trimmed(padded_name), residue_name)) return *element;
  return element_of_padded_name(text);
}

std::uint8_t element_of_bare_name(std::string_view name, std::string_view residue_name) {
  name = trimmed(name);
  if (name.empty()) return 0;
  if (const auto element = element_by_residue(name, residue_name)) return *element;
  const std::string capitals = upper_case(name);
  const std::string_view letters = without_leading_digits(capitals);
  if (letters.size() < 2) return element_number(letters);
  return element_of_capitals(letters[0], letters[1]);
}

}  // namespace pliant
