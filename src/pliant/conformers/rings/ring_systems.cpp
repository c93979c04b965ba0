// SPDX-License-Identifier: MIT
#include "pliant/conformers/rings/ring_systems.hpp"

#include <algorithm>
#include <map>

#include "pliant/conformers/rings/ring_pucker.hpp"

namespace pliant {
namespace {

constexpr std::size_t most_bonds = 64;

using Path = std::vector<std::size_t>;

/// Cycles of at most `largest` atoms from their lowest atom on, each once.
void find_rings(const RingSystem& system, std::size_t largest, Path& path,
                std::vector<Path>& rings) {
  for (std::size_t next : system.neighbours[path.back()]) {
    if (next == path.front() && path.size() > 2 && path[1] < path.back()) rings.push_back(path);
    if (next <= path.front() || path.size() == largest) continue;
    if (std::find(path.begin(), path.end(), next) != path.end()) continue;
    path.push_back(next);
    find_rings(system, largest, path, rings);
    path.pop_back();
  }
}

/// A ring as the set of its bonds.
std::uint64_t bonds_of(const Path& ring,
                       const std::map<std::pair<std::size_t, std::size_t>, std::size_t>& number) {
  std::uint64_t set = 0;
  for (std::size_t k = 0; k < ring.size(); ++k)
    set ^= std::uint64_t{1} << number.at(std::minmax(ring[k], ring[(k + 1) % ring.size()]));
  return set;
}

/// How many of the rings do not follow from others (rank over two numbers).
std::size_t independent(const RingSystem& system) {
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> number;
  for (std::size_t a = 0; a < system.atoms.size(); ++a)
    for (std::size_t b : system.neighbours[a])
      if (a < b) number.emplace(std::pair{a, b}, number.size());
  std::vector<std::uint64_t> basis;
  for (const Path& ring : system.rings) {
    std::uint64_t set = bonds_of(ring, number);
    for (std::uint64_t known : basis) set = std::min(set, set ^ known);
    if (set != 0) basis.push_back(set);
  }
  return basis.size();
}

RingSystem system_of(const std::vector<Bar>& bonds) {
  RingSystem system;
  for (const Bar& bond : bonds) system.atoms.insert(system.atoms.end(), {bond.a, bond.b});
  std::sort(system.atoms.begin(), system.atoms.end());
  system.atoms.erase(std::unique(system.atoms.begin(), system.atoms.end()), system.atoms.end());
  system.neighbours.resize(system.atoms.size());
  const auto place = [&](Joint atom) {
    return std::size_t(std::lower_bound(system.atoms.begin(), system.atoms.end(), atom) -
                       system.atoms.begin());
  };
  for (const Bar& bond : bonds) {
    system.neighbours[place(bond.a)].push_back(place(bond.b));
    system.neighbours[place(bond.b)].push_back(place(bond.a));
  }
  for (auto& at : system.neighbours) std::sort(at.begin(), at.end());
  return system;
}

/// Looks for rings of up to so many atoms; whether all others follow from them.
bool has_only_rings_of(RingSystem& system, std::size_t largest, std::size_t cycles) {
  system.rings.clear();
  for (std::size_t k = 0; k < system.atoms.size(); ++k) {
    Path path{k};
    find_rings(system, largest, path, system.rings);
  }
  return independent(system) == cycles;
}

/// Whether a bond between flat atoms keeps each ring of seven from turning as a loop: six torsions
/// are as many as closing a ring takes.
bool are_sevens_held(const RingSystem& system, const BondChemistry& chemistry) {
  return std::all_of(system.rings.begin(), system.rings.end(), [&](const Path& ring) {
    if (ring.size() <= largest_small_ring) return true;
    for (std::size_t k = 0; k < ring.size(); ++k)
      if (!chemistry.is_tetrahedral(system.atoms[ring[k]]) &&
          !chemistry.is_tetrahedral(system.atoms[ring[(k + 1) % ring.size()]]))
        return true;
    return false;
  });
}

bool has_known_rings(RingSystem& system, std::size_t cycles, const BondChemistry& chemistry) {
  return has_only_rings_of(system, largest_small_ring, cycles) ||
         (has_only_rings_of(system, largest_small_ring + 1, cycles) &&
          are_sevens_held(system, chemistry));
}

}  // namespace

std::vector<RingSystem> ring_systems(const BondChemistry& chemistry) {
  std::vector<RingSystem> systems;
  for (const std::vector<Bar>& bonds : chemistry.ring_blocks()) {
    if (bonds.size() > most_bonds) continue;
    RingSystem system = system_of(bonds);
    const std::size_t cycles = bonds.size() - system.atoms.size() + 1;
    const bool is_flat = std::none_of(system.atoms.begin(), system.atoms.end(),
                                      [&](Joint atom) { return chemistry.is_tetrahedral(atom); });
    if (cycles > 1 && !is_flat && has_known_rings(system, cycles, chemistry))
      systems.push_back(std::move(system));
  }
  std::sort(systems.begin(), systems.end(),
            [](const RingSystem& one, const RingSystem& other) { return one.atoms < other.atoms; });
  return systems;
}

std::vector<Bar> system_angles(const RingSystem& system, const BondChemistry& chemistry) {
  std::vector<Bar> pairs;
  for (std::size_t k = 0; k < system.atoms.size(); ++k) {
    if (!chemistry.is_tetrahedral(system.atoms[k])) continue;
    for (std::size_t side : system.neighbours[k])
      for (const Link& bond : chemistry.bonds_at(system.atoms[k])) {
        const Joint one = system.atoms[side], other = bond.node;
        if (one != other && !chemistry.is_bonded(one, other))
          pairs.push_back({std::min(one, other), std::max(one, other)});
      }
  }
  sort_pairs(pairs);
  return pairs;
}

}  // namespace pliant
