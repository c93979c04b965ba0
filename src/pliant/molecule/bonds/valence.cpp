// SPDX-License-Identifier: MIT
#include "pliant/molecule/bonds/valence.hpp"

#include <algorithm>
#include <iterator>

#include "pliant/base/elements.hpp"

namespace pliant::perception {
namespace {

struct ElementValence {
  std::uint8_t element;
  std::uint8_t neighbours;
};

constexpr ElementValence valences[] = {{1, 1},  {2, 0},  {5, 4},  {6, 4},  {7, 4},  {8, 3},
                                       {9, 1},  {10, 0}, {14, 6}, {15, 6}, {16, 6}, {17, 4},
                                       {18, 0}, {32, 6}, {33, 6}, {34, 6}, {35, 5}, {36, 2},
                                       {51, 6}, {52, 6}, {53, 7}, {54, 6}, {85, 1}, {86, 2}};

}  // namespace

std::uint8_t most_neighbours(std::uint8_t element) {
  for (const ElementValence& row : valences)
    if (row.element == element) return row.neighbours;
  return is_metal(element) ? 12 : 6;
}

bool is_halogen(std::uint8_t element) {
  return element == 9 || element == 17 || element == 35 || element == 53;
}

bool is_always_ion(std::uint8_t element) {
  constexpr std::uint8_t ions[] = {3, 11, 19, 20, 37, 38, 55, 56, 87, 88};
  return std::ranges::find(ions, element) != std::end(ions);
}

void KnownBonds::add(const Bond& bond) {
  ++neighbours;
  orders += bond.order == 0 ? 1.0 : bond.order == 4 ? 1.5 : bond.order;
}

bool are_full(std::uint8_t element, KnownBonds known) {
  switch (element) {
    case 6:
      return known.orders >= 4.0;
    case 7:
      return known.neighbours >= 3;
    case 8:
      return known.neighbours >= 2;
    default:
      return (element == 1 || is_halogen(element)) && known.neighbours >= 1;
  }
}

}  // namespace pliant::perception
