// SPDX-License-Identifier: MIT
#include "pliant/sample/pocket/rotamer_table.hpp"

#include <algorithm>

namespace pliant {
namespace {

constexpr SideChainAtoms chains[] = {
    {"ARG", {"N", "CA", "CB", "CG", "CD", "NE", "CZ"}},
    {"ASN", {"N", "CA", "CB", "CG", "OD1"}},
    {"ASP", {"N", "CA", "CB", "CG", "OD1"}},
    {"CYS", {"N", "CA", "CB", "SG"}},
    {"GLN", {"N", "CA", "CB", "CG", "CD", "OE1"}},
    {"GLU", {"N", "CA", "CB", "CG", "CD", "OE1"}},
    {"HIS", {"N", "CA", "CB", "CG", "ND1"}},
    {"ILE", {"N", "CA", "CB", "CG1", "CD1"}},
    {"LEU", {"N", "CA", "CB", "CG", "CD1"}},
    {"LYS", {"N", "CA", "CB", "CG", "CD", "CE", "NZ"}},
    {"MET", {"N", "CA", "CB", "CG", "SD", "CE"}},
    {"PHE", {"N", "CA", "CB", "CG", "CD1"}},
    {"SER", {"N", "CA", "CB", "OG"}},
    {"THR", {"N", "CA", "CB", "OG1"}},
    {"TRP", {"N", "CA", "CB", "CG", "CD1"}},
    {"TYR", {"N", "CA", "CB", "CG", "CD1"}},
    {"VAL", {"N", "CA", "CB", "CG1"}},
};

constexpr Rotamer rotamers[] = {
    {"ARG", 0, {60, 180}, 11},         {"ARG", 0, {180, 60}, 5},
    {"ARG", 0, {180, 180}, 32},        {"ARG", 0, {300, 180}, 42},
    {"ARG", 0, {300, 300}, 6},         {"ARG", 2, {60, no_torsion}, 19},
    {"ARG", 2, {180, no_torsion}, 50}, {"ARG", 2, {300, no_torsion}, 31},
    {"ARG", 3, {60, no_torsion}, 22},  {"ARG", 3, {180, no_torsion}, 52},
    {"ARG", 3, {300, no_torsion}, 26}, {"ASN", 0, {60, 0}, 2},
    {"ASN", 0, {60, 300}, 2},          {"ASN", 0, {60, 330}, 2},
    {"ASN", 0, {180, 0}, 6},           {"ASN", 0, {180, 30}, 4},
    {"ASN", 0, {180, 60}, 2},          {"ASN", 0, {180, 210}, 2},
    {"ASN", 0, {180, 300}, 2},         {"ASN", 0, {180, 330}, 6},
    {"ASN", 0, {300, 0}, 9},           {"ASN", 0, {300, 30}, 4},
    {"ASN", 0, {300, 120}, 2},         {"ASN", 0, {300, 150}, 5},
    {"ASN", 0, {300, 270}, 4},         {"ASN", 0, {300, 300}, 11},
    {"ASN", 0, {300, 330}, 20},        {"ASP", 0, {60, 0}, 8},
    {"ASP", 0, {60, 30}, 4},           {"ASP", 0, {60, 150}, 4},
    {"ASP", 0, {180, 0}, 9},           {"ASP", 0, {180, 30}, 9},
    {"ASP", 0, {180, 60}, 4},          {"ASP", 0, {180, 150}, 6},
    {"ASP", 0, {300, 0}, 13},          {"ASP", 0, {300, 30}, 3},
    {"ASP", 0, {300, 60}, 3},          {"ASP", 0, {300, 90}, 2},
    {"ASP", 0, {300, 120}, 11},        {"ASP", 0, {300, 150}, 21},
    {"CYS", 0, {60, no_torsion}, 9},   {"CYS", 0, {180, no_torsion}, 42},
    {"CYS", 0, {300, no_torsion}, 48}, {"GLN", 0, {60, 180}, 7},
    {"GLN", 0, {180, 60}, 10},         {"GLN", 0, {180, 180}, 21},
    {"GLN", 0, {300, 180}, 40},        {"GLN", 0, {300, 300}, 18},
    {"GLN", 2, {0, no_torsion}, 11},   {"GLN", 2, {30, no_torsion}, 11},
    {"GLN", 2, {60, no_torsion}, 14},  {"GLN", 2, {90, no_torsion}, 2},
    {"GLN", 2, {120, no_torsion}, 7},  {"GLN", 2, {150, no_torsion}, 4},
    {"GLN", 2, {180, no_torsion}, 5},  {"GLN", 2, {210, no_torsion}, 4},
    {"GLN", 2, {240, no_torsion}, 4},  {"GLN", 2, {270, no_torsion}, 8},
    {"GLN", 2, {300, no_torsion}, 16}, {"GLN", 2, {330, no_torsion}, 14},
    {"GLU", 0, {60, 180}, 11},         {"GLU", 0, {60, 300}, 3},
    {"GLU", 0, {180, 60}, 10},         {"GLU", 0, {180, 180}, 22},
    {"GLU", 0, {300, 60}, 7},          {"GLU", 0, {300, 180}, 34},
    {"GLU", 0, {300, 300}, 12},        {"GLU", 2, {0, no_torsion}, 26},
    {"GLU", 2, {30, no_torsion}, 21},  {"GLU", 2, {60, no_torsion}, 11},
    {"GLU", 2, {90, no_torsion}, 9},   {"GLU", 2, {120, no_torsion}, 15},
    {"GLU", 2, {150, no_torsion}, 17}, {"HIS", 0, {60, 60}, 2},
    {"HIS", 0, {60, 90}, 5},           {"HIS", 0, {60, 270}, 2},
    {"HIS", 0, {60, 300}, 2},          {"HIS", 0, {180, 60}, 5},
    {"HIS", 0, {180, 90}, 4},          {"HIS", 0, {180, 240}, 3},
    {"HIS", 0, {180, 270}, 8},         {"HIS", 0, {180, 300}, 5},
    {"HIS", 0, {300, 30}, 3},          {"HIS", 0, {300, 60}, 5},
    {"HIS", 0, {300, 90}, 10},         {"HIS", 0, {300, 120}, 3},
    {"HIS", 0, {300, 150}, 3},         {"HIS", 0, {300, 180}, 7},
    {"HIS", 0, {300, 210}, 2},         {"HIS", 0, {300, 270}, 13},
    {"HIS", 0, {300, 300}, 14},        {"ILE", 0, {60, 180}, 14},
    {"ILE", 0, {180, 60}, 4},          {"ILE", 0, {180, 180}, 14},
    {"ILE", 0, {300, 60}, 3},          {"ILE", 0, {300, 180}, 46},
    {"ILE", 0, {300, 300}, 16},        {"LEU", 0, {180, 60}, 32},
    {"LEU", 0, {180, 180}, 4},         {"LEU", 0, {300, 60}, 8},
    {"LEU", 0, {300, 180}, 52},        {"LYS", 0, {60, 180}, 12},
    {"LYS", 0, {180, 60}, 6},          {"LYS", 0, {180, 180}, 30},
    {"LYS", 0, {300, 180}, 42},        {"LYS", 0, {300, 300}, 7},
    {"LYS", 2, {60, no_torsion}, 12},  {"LYS", 2, {180, no_torsion}, 77},
    {"LYS", 2, {300, no_torsion}, 11}, {"LYS", 3, {60, no_torsion}, 19},
    {"LYS", 3, {180, no_torsion}, 70}, {"LYS", 3, {300, no_torsion}, 11},
    {"MET", 0, {60, 180}, 13},         {"MET", 0, {180, 60}, 8},
    {"MET", 0, {180, 180}, 23},        {"MET", 0, {180, 300}, 3},
    {"MET", 0, {300, 180}, 37},        {"MET", 0, {300, 300}, 16},
    {"MET", 2, {60, no_torsion}, 38},  {"MET", 2, {180, no_torsion}, 24},
    {"MET", 2, {300, no_torsion}, 38}, {"PHE", 0, {60, 90}, 16},
    {"PHE", 0, {60, 120}, 3},          {"PHE", 0, {180, 30}, 2},
    {"PHE", 0, {180, 60}, 12},         {"PHE", 0, {180, 90}, 19},
    {"PHE", 0, {300, 60}, 3},          {"PHE", 0, {300, 90}, 36},
    {"PHE", 0, {300, 120}, 4},         {"SER", 0, {60, no_torsion}, 52},
    {"SER", 0, {180, no_torsion}, 22}, {"SER", 0, {300, no_torsion}, 26},
    {"THR", 0, {60, no_torsion}, 44},  {"THR", 0, {180, no_torsion}, 10},
    {"THR", 0, {300, no_torsion}, 46}, {"TRP", 0, {60, 90}, 6},
    {"TRP", 0, {60, 270}, 10},         {"TRP", 0, {180, 60}, 8},
    {"TRP", 0, {180, 240}, 8},         {"TRP", 0, {180, 270}, 5},
    {"TRP", 0, {300, 0}, 7},           {"TRP", 0, {300, 60}, 5},
    {"TRP", 0, {300, 90}, 28},         {"TRP", 0, {300, 120}, 16},
    {"TYR", 0, {60, 90}, 13},          {"TYR", 0, {180, 60}, 10},
    {"TYR", 0, {180, 90}, 17},         {"TYR", 0, {300, 0}, 4},
    {"TYR", 0, {300, 60}, 4},          {"TYR", 0, {300, 90}, 36},
    {"TYR", 0, {300, 120}, 9},         {"TYR", 0, {300, 150}, 3},
    {"VAL", 0, {60, no_torsion}, 10},  {"VAL", 0, {180, no_torsion}, 64},
    {"VAL", 0, {300, no_torsion}, 26},
};

}  // namespace

std::string_view amino_acid_of(std::string_view residue) {
  constexpr std::string_view histidines[] = {"HID", "HIE", "HIP", "HSD", "HSE", "HSP"};
  return std::ranges::find(histidines, residue) == std::end(histidines) ? residue : "HIS";
}

std::span<const std::string_view> atoms_along_side_chain(std::string_view residue) {
  const auto found = std::ranges::find(chains, residue, &SideChainAtoms::residue);
  if (found == std::end(chains)) return {};
  const auto end = std::ranges::find(found->atoms, std::string_view{});
  return {found->atoms.begin(), end};
}

std::span<const Rotamer> rotamers_of(std::string_view residue, std::size_t first) {
  const auto is_one = [&](const Rotamer& row) {
    return row.residue == residue && row.first == first;
  };
  const auto begin = std::ranges::find_if(rotamers, is_one);
  return {begin, std::find_if_not(begin, std::end(rotamers), is_one)};
}

}  // namespace pliant
