// SPDX-License-Identifier: MIT
#include "pliant/molecule/bonds/perception.hpp"

#include <algorithm>

#include "pliant/base/graphs/grouped.hpp"

namespace pliant::perception {
namespace {

/// 9999.999 is what fits a PDB field, 9999 what CHARMM writes: a position that nobody knew.
bool is_placeholder(Vec3 p) {
  return p.x == p.y && p.y == p.z && (p.x == 9999.999 || p.x == 9999.0);
}

// The longest true bonds of templates are C-S and C-Se, 1.8 and 1.95 Angstrom.
constexpr double longest_heavy = 3.0;
constexpr double longest_to_hydrogen = 2.0;

}  // namespace

double longest_template_bond(const Structure& structure, std::uint32_t a, std::uint32_t b) {
  constexpr std::uint8_t hydrogen = 1;
  const auto& elements = structure.atoms.elements;
  return elements[a] == hydrogen || elements[b] == hydrogen ? longest_to_hydrogen : longest_heavy;
}

Perception::Perception(const Structure& given, const BondOptions& chosen)
    : structure(given), options(chosen), settled(given.size(), false), bonds(given.bonds) {
  keys.reserve(given.size());
  excluded.reserve(given.size());
  for (std::size_t i = 0; i < given.size(); ++i) {
    keys.push_back(atom_key(given.atoms.names[i], given.atoms.elements[i] == 1));
    excluded.push_back(is_placeholder(given.positions[i]));
    if (excluded[i]) unplaced.add([&] { return given.atoms.label(i); });
  }
}

std::uint32_t Perception::find(const ResiduePiece& piece, AtomKey key) const {
  for (std::uint32_t atom = piece.first; atom < piece.last; ++atom)
    if (keys[atom] == key) return atom;
  return static_cast<std::uint32_t>(structure.size());
}

void sort_and_merge(std::vector<Bond>& bonds, std::size_t atom_count) {
  Grouped<Bond, std::size_t> by_atom(atom_count, [&](const auto& put) {
    for (const Bond& bond : bonds) put(bond.a, bond);
  });
  bonds.clear();
  for (std::size_t i = 0; i < atom_count; ++i) {
    const std::span<Bond> here = by_atom.at(i);
    std::stable_sort(here.begin(), here.end(), [](const Bond& x, const Bond& y) {
      return x.b != y.b ? x.b < y.b : x.origin < y.origin;
    });
    for (std::size_t k = 0; k < here.size(); ++k) {
      const bool repeats = k > 0 && here[k].b == bonds.back().b;
      if (!repeats) bonds.push_back(here[k]);
      if (repeats && bonds.back().order == 0) bonds.back().order = here[k].order;
    }
  }
}

}  // namespace pliant::perception
