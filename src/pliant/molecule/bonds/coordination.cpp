// SPDX-License-Identifier: MIT
#include "pliant/molecule/bonds/coordination.hpp"

#include <algorithm>
#include <initializer_list>

#include "pliant/base/elements.hpp"

namespace pliant {
namespace {

constexpr double usual_reach = 2.8;
constexpr double largest_ratio = 1.2;  // to the sum of covalent radii
// The bonds of CO, cyanide and adenosyl are 1.8 to 2.1 long. The C of a carboxylate that holds a
// metal with both O is further than this.
constexpr double reach_to_carbon = 2.3;
constexpr std::uint8_t carbon = 6;

bool is_one_of(std::uint8_t element, std::initializer_list<std::uint8_t> elements) {
  return std::ranges::find(elements, element) != elements.end();
}

}  // namespace

double coordination_reach(std::uint8_t metal, std::uint8_t held) {
  if (held == carbon) return reach_to_carbon;
  if (is_one_of(held, {9, 17, 34, 35, 53})) return usual_reach;
  if (!is_one_of(held, {7, 8, 16})) return 0.0;
  return std::max(usual_reach, largest_ratio * (covalent_radius(metal) + covalent_radius(held)));
}

bool is_coordination(const AtomTable& atoms, const Bond& bond) {
  return is_metal(atoms.elements[bond.a]) != is_metal(atoms.elements[bond.b]) &&
         atoms.residue_of[bond.a] != atoms.residue_of[bond.b];
}

}  // namespace pliant
