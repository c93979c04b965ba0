// SPDX-License-Identifier: MIT
// How many bonds atoms of an element take. Internal: bonds by distance ask it.
#pragma once

#include <cstdint>

#include "pliant/molecule/structure/structure.hpp"

namespace pliant::perception {

/// The most neighbours (not bond orders) that atoms have in molecules: NH4+, H3O+, SF6, IF7, XeF6;
/// 12 of metals (ferrocene has 10).
std::uint8_t most_neighbours(std::uint8_t element);

bool is_halogen(std::uint8_t element);

/// Alkali metals, and alkaline earth metals but beryllium and magnesium (chlorophyll): ions always.
bool is_always_ion(std::uint8_t element);

/// What an atom has of bonds to other than metals.
struct KnownBonds {
  std::uint32_t neighbours = 0;
  double orders = 0.0;  ///< their sum, unknown ones as 1

  void add(const Bond& bond);
};

/// Whether known bonds leave an atom no place for another heavy atom. A double bond of O or N may
/// be drawn at either of two; carbon's is sure.
bool are_full(std::uint8_t element, KnownBonds known);

}  // namespace pliant::perception
