// SPDX-License-Identifier: MIT
#include "pliant/base/elements.hpp"

#include <array>

namespace pliant {
namespace {

struct Element {
  std::string_view symbol;
  double mass;    // u
  double radius;  // Angstrom
  bool metal;     // metalloids (B, Si, Ge, As, Sb, Te) are not: they make directed bonds
};

// clang-format off
constexpr std::array<Element, element_count + 1> elements{{
    {"X", 1.0, 0.0, false}, {"H", 1.008, 0.31, false}, {"He", 4.002602, 0.28, false},
    {"Li", 6.94, 1.28, true}, {"Be", 9.0121831, 0.96, true}, {"B", 10.81, 0.84, false},
    {"C", 12.011, 0.76, false}, {"N", 14.007, 0.71, false}, {"O", 15.999, 0.66, false},
    {"F", 18.998403162, 0.57, false}, {"Ne", 20.1797, 0.58, false}, {"Na", 22.98976928, 1.66, true},
    {"Mg", 24.305, 1.41, true}, {"Al", 26.9815384, 1.21, true}, {"Si", 28.085, 1.11, false},
    {"P", 30.973761998, 1.07, false}, {"S", 32.06, 1.05, false}, {"Cl", 35.45, 1.02, false},
    {"Ar", 39.95, 1.06, false}, {"K", 39.0983, 2.03, true}, {"Ca", 40.078, 1.76, true},
    {"Sc", 44.955907, 1.7, true}, {"Ti", 47.867, 1.6, true}, {"V", 50.9415, 1.53, true},
    {"Cr", 51.9961, 1.39, true}, {"Mn", 54.938043, 1.39, true}, {"Fe", 55.845, 1.32, true},
    {"Co", 58.933194, 1.26, true}, {"Ni", 58.6934, 1.24, true}, {"Cu", 63.546, 1.32, true},
    {"Zn", 65.38, 1.22, true}, {"Ga", 69.723, 1.22, true}, {"Ge", 72.63, 1.2, false},
    {"As", 74.921595, 1.19, false}, {"Se", 78.971, 1.2, false}, {"Br", 79.904, 1.2, false},
    {"Kr", 83.798, 1.16, false}, {"Rb", 85.4678, 2.2, true}, {"Sr", 87.62, 1.95, true},
    {"Y", 88.905838, 1.9, true}, {"Zr", 91.224, 1.75, true}, {"Nb", 92.90637, 1.64, true},
    {"Mo", 95.95, 1.54, true}, {"Tc", 97.0, 1.47, true}, {"Ru", 101.07, 1.46, true},
    {"Rh", 102.90549, 1.42, true}, {"Pd", 106.42, 1.39, true}, {"Ag", 107.8682, 1.45, true},
    {"Cd", 112.414, 1.44, true}, {"In", 114.818, 1.42, true}, {"Sn", 118.71, 1.39, true},
    {"Sb", 121.76, 1.39, false}, {"Te", 127.6, 1.38, false}, {"I", 126.90447, 1.39, false},
    {"Xe", 131.293, 1.4, false}, {"Cs", 132.90545196, 2.44, true}, {"Ba", 137.327, 2.15, true},
    {"La", 138.90547, 2.07, true}, {"Ce", 140.116, 2.04, true}, {"Pr", 140.90766, 2.03, true},
    {"Nd", 144.242, 2.01, true}, {"Pm", 145.0, 1.99, true}, {"Sm", 150.36, 1.98, true},
    {"Eu", 151.964, 1.98, true}, {"Gd", 157.25, 1.96, true}, {"Tb", 158.925354, 1.94, true},
    {"Dy", 162.5, 1.92, true}, {"Ho", 164.930329, 1.92, true}, {"Er", 167.259, 1.89, true},
    {"Tm", 168.934219, 1.9, true}, {"Yb", 173.045, 1.87, true}, {"Lu", 174.9668, 1.87, true},
    {"Hf", 178.486, 1.75, true}, {"Ta", 180.94788, 1.7, true}, {"W", 183.84, 1.62, true},
    {"Re", 186.207, 1.51, true}, {"Os", 190.23, 1.44, true}, {"Ir", 192.217, 1.41, true},
    {"Pt", 195.084, 1.36, true}, {"Au", 196.96657, 1.36, true}, {"Hg", 200.592, 1.32, true},
    {"Tl", 204.38, 1.45, true}, {"Pb", 207.2, 1.46, true}, {"Bi", 208.9804, 1.48, true},
    {"Po", 209.0, 1.4, true}, {"At", 210.0, 1.5, false}, {"Rn", 222.0, 1.5, false},
    {"Fr", 223.0, 2.6, true}, {"Ra", 226.0, 2.21, true}, {"Ac", 227.0, 2.15, true},
    {"Th", 232.0377, 2.06, true}, {"Pa", 231.03588, 2.0, true}, {"U", 238.02891, 1.96, true},
    {"Np", 237.0, 1.9, true}, {"Pu", 244.0, 1.87, true}, {"Am", 243.0, 1.8, true},
    {"Cm", 247.0, 1.69, true}, {"Bk", 247.0, 0.0, true}, {"Cf", 251.0, 0.0, true},
    {"Es", 252.0, 0.0, true}, {"Fm", 257.0, 0.0, true}, {"Md", 258.0, 0.0, true},
    {"No", 259.0, 0.0, true}, {"Lr", 262.0, 0.0, true}, {"Rf", 267.0, 0.0, true},
    {"Db", 268.0, 0.0, true}, {"Sg", 269.0, 0.0, true}, {"Bh", 270.0, 0.0, true},
    {"Hs", 269.0, 0.0, true}, {"Mt", 277.0, 0.0, true}, {"Ds", 281.0, 0.0, true},
    {"Rg", 282.0, 0.0, true}, {"Cn", 285.0, 0.0, true}, {"Nh", 286.0, 0.0, true},
    {"Fl", 290.0, 0.0, true}, {"Mc", 290.0, 0.0, true}, {"Lv", 293.0, 0.0, true},
    {"Ts", 294.0, 0.0, false}, {"Og", 294.0, 0.0, false}
}};
// clang-format on

constexpr char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c; }

constexpr std::size_t slots = std::size_t(26) * 27;

/// Index of an upper-case symbol of one or two letters in a 27 x 26 table.
constexpr std::size_t slot(char first, char second) {
  const auto place = [](char letter) { return static_cast<std::size_t>(letter - 'A'); };
  return place(first) * 27 + (second == 0 ? 0 : place(second) + 1);
}

constexpr std::array<std::uint8_t, slots> make_numbers() {
  std::array<std::uint8_t, slots> numbers{};
  for (std::uint8_t z = 1; z <= element_count; ++z) {
    const std::string_view symbol = elements[z].symbol;
    numbers[slot(symbol[0], symbol.size() > 1 ? upper(symbol[1]) : char(0))] = z;
  }
  numbers[slot('D', 0)] = numbers[slot('T', 0)] = 1;  // deuterium and tritium
  return numbers;
}
constexpr auto numbers = make_numbers();

const Element& element(std::uint8_t number) {
  return elements[number <= element_count ? number : 0];
}

}  // namespace

std::string_view element_symbol(std::uint8_t number) { return element(number).symbol; }

std::uint8_t element_number(std::string_view symbol) {
  if (symbol.empty() || symbol.size() > 2) return 0;
  const char first = upper(symbol[0]);
  const char second = symbol.size() > 1 ? upper(symbol[1]) : char(0);
  const bool letters =
      first >= 'A' && first <= 'Z' && (second == 0 || (second >= 'A' && second <= 'Z'));
  return letters && (symbol.size() == 1 || second != 0) ? numbers[slot(first, second)] : 0;
}

double element_mass(std::uint8_t number) { return element(number).mass; }

double covalent_radius(std::uint8_t number) { return element(number).radius; }

bool is_metal(std::uint8_t number) { return element(number).metal; }

}  // namespace pliant
