// SPDX-License-Identifier: MIT
// Chemical elements: symbols, masses, covalent radii.
#pragma once

#include <cstdint>
#include <string_view>

namespace pliant {

inline constexpr std::uint8_t element_count = 118;

/// "C" for 6; "X" for 0 (unknown or dummy).
std::string_view element_symbol(std::uint8_t number);

/// Atomic number of a symbol in any case ("CL", "Cl", "D" = 1); 0 if there is no such element.
std::uint8_t element_number(std::string_view symbol);

/// Standard atomic weight (u; IUPAC 2021), or the mass number of the longest-lived isotope where
/// there is none. 1 for element 0.
double element_mass(std::uint8_t number);

/// Covalent radius (Angstrom; Cordero et al., Dalton Trans. 2008, 2832: sp3 carbon, low-spin
/// metals). 0 for element 0 and for elements above 96, which have none.
double covalent_radius(std::uint8_t number);

/// Whether an element is a metal: metals make no bonds by distance.
bool is_metal(std::uint8_t number);

}  // namespace pliant
