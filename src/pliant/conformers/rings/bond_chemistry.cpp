// SPDX-License-Identifier: MIT
#include "pliant/conformers/rings/bond_chemistry.hpp"

#include <algorithm>

#include "pliant/base/elements.hpp"

namespace pliant {
namespace {

/// Bars of at most this many times the sum of covalent radii are bonds; those across an angle are
/// longer by half.
constexpr double longest_bond = 1.25;
/// Length of the sum of three bonds of length 1: 1 for sp3, 0 in a plane.
constexpr double least_pyramid = 0.35;

constexpr std::size_t smallest_ring = 5;
/// Trans amides are strained in rings of up to so many.
constexpr std::size_t largest_that_stays = 8;

Vec3 direction(Vec3 from, Vec3 to) { return (1.0 / distance(from, to)) * (to - from); }

}  // namespace

BondChemistry::BondChemistry(const Framework& framework, std::span<const Vec3> start)
    : framework_(framework),
      start_(start),
      bonds_(framework.joint_count(), edges_),
      is_in_ring_(framework.joint_count(), false) {
  if (framework.atoms() == nullptr) return;
  const auto bars = framework.bars();
  for (BarIndex k = 0; k < bars.size(); ++k) {
    const double radii = covalent_radius(element(bars[k].a)) + covalent_radius(element(bars[k].b));
    if (framework.rest_lengths()[k] <= longest_bond * radii) edges_.push_back(bars[k]);
  }
  bonds_ = Graph(framework.joint_count(), edges_);
  const Blocks blocks = find_blocks(bonds_);
  for (std::size_t edge = 0; edge < edges_.size(); ++edge) {
    is_ring_bond_.push_back(!blocks.is_bridge[edge]);
    if (is_ring_bond_[edge]) is_in_ring_[edges_[edge].a] = is_in_ring_[edges_[edge].b] = true;
  }
}

std::uint8_t BondChemistry::element(Joint atom) const {
  return framework_.atoms() != nullptr ? framework_.atoms()->elements[atom] : std::uint8_t{0};
}

bool BondChemistry::is_tetrahedral(Joint atom) const {
  const auto bonds = bonds_at(atom);
  if (bonds.size() > 3) return true;
  if (bonds.size() == 2) return element(atom) == 8 || element(atom) == 16;
  Vec3 sum{};
  for (const Link& bond : bonds) sum += direction(start_[atom], start_[bond.node]);
  return norm(sum) > least_pyramid;
}

bool BondChemistry::spins_alike(Joint from, Joint atom) const {
  const auto bonds = bonds_at(atom);
  return bonds.size() > 3 && std::all_of(bonds.begin(), bonds.end(), [&](const Link& bond) {
           return bond.node == from || is_hydrogen(bond.node);
         });
}

Joint BondChemistry::reference(Joint atom, Joint except) const {
  Joint found = atom;
  int best = -1;
  for (const Link& bond : bonds_at(atom)) {
    if (bond.node == except) continue;
    const int here = rank_of(bond);
    if (here <= best) continue;
    best = here;
    found = bond.node;
  }
  return found;
}

int BondChemistry::rank_of(const Link& bond) const {
  if (is_hydrogen(bond.node)) return 0;
  const std::size_t count = bonds_at(bond.node).size();
  if (count == 1) return 1;
  if (!is_ring_bond_[bond.edge]) return is_acyl(bond.node) || element(bond.node) == 16 ? 3 : 2;
  return is_nitrogen(bond.node) && count == 2 ? 5 : 4;
}

std::vector<std::vector<Bar>> BondChemistry::ring_blocks() const {
  const Blocks blocks = find_blocks(bonds_);
  std::vector<std::vector<Bar>> of_block(blocks.count);
  for (std::uint32_t edge = 0; edge < edges_.size(); ++edge)
    if (!blocks.is_bridge[edge]) of_block[blocks.of_edge[edge]].push_back(edges_[edge]);
  std::erase_if(of_block, [](const std::vector<Bar>& edges) { return edges.empty(); });
  return of_block;
}

/// A block that has as many bonds as atoms is a ring alone.
std::vector<SimpleRing> BondChemistry::simple_rings() const {
  std::vector<SimpleRing> rings;
  for (const std::vector<Bar>& edges : ring_blocks())
    if (edges.size() >= smallest_ring)
      if (SimpleRing ring = in_order(edges); !ring.empty()) rings.push_back(std::move(ring));
  std::sort(rings.begin(), rings.end());
  return rings;
}

bool BondChemistry::is_bonded(Joint a, Joint b) const {
  const auto bonds = bonds_at(a);
  return std::any_of(bonds.begin(), bonds.end(), [&](const Link& bond) { return bond.node == b; });
}

/// The atoms round the ring from its lowest one; empty if it is none.
SimpleRing BondChemistry::in_order(const std::vector<Bar>& edges) {
  std::vector<std::pair<Joint, Joint>> steps;
  for (const Bar& edge : edges) {
    steps.emplace_back(edge.a, edge.b);
    steps.emplace_back(edge.b, edge.a);
  }
  std::sort(steps.begin(), steps.end());
  for (std::size_t k = 0; k < steps.size(); ++k)
    if (steps[k].first != steps[k - k % 2].first) return {};
  if (steps.size() % 2 != 0 || steps[0].first != steps[1].first) return {};
  SimpleRing ring{steps[0].first};
  Joint before = ring[0], now = steps[0].second;
  while (now != ring[0] && ring.size() <= edges.size()) {
    ring.push_back(now);
    const auto at = std::lower_bound(steps.begin(), steps.end(), std::pair(now, Joint{0}));
    const Joint next = at->second == before ? (at + 1)->second : at->second;
    before = now;
    now = next;
  }
  return ring.size() == edges.size() ? ring : SimpleRing{};
}

bool BondChemistry::is_aryl(Joint atom) const {
  const auto is_flat = [&](Joint at) {
    return bonds_at(at).size() == 2 || (bonds_at(at).size() == 3 && !is_tetrahedral(at));
  };
  const auto bonds = bonds_at(atom);
  return is_in_ring(atom) && bonds.size() == 3 && is_flat(atom) &&
         std::all_of(bonds.begin(), bonds.end(), [&](const Link& bond) {
           return !is_ring_bond_[bond.edge] || is_flat(bond.node);
         });
}

int BondChemistry::heavy_bonds_at(Joint atom) const {
  const auto bonds = bonds_at(atom);
  return static_cast<int>(std::count_if(bonds.begin(), bonds.end(),
                                        [&](const Link& bond) { return !is_hydrogen(bond.node); }));
}

bool BondChemistry::is_flanked(Joint aryl) const {
  const auto bonds = bonds_at(aryl);
  return std::count_if(bonds.begin(), bonds.end(), [&](const Link& bond) {
           return is_ring_bond_[bond.edge] && heavy_bonds_at(bond.node) > 2;
         }) > 1;
}

bool BondChemistry::is_conjugated(Joint atom) const {
  return !is_tetrahedral(atom) || ((is_nitrogen(atom) || is_oxygen(atom)) && is_beside_acyl(atom));
}

bool BondChemistry::is_beside_acyl(Joint atom) const {
  const auto bonds = bonds_at(atom);
  return std::any_of(bonds.begin(), bonds.end(),
                     [&](const Link& bond) { return is_acyl(bond.node); });
}

bool BondChemistry::is_acyl(Joint atom) const {
  const auto bonds = bonds_at(atom);
  return element(atom) == 6 && bonds.size() == 3 && !is_tetrahedral(atom) &&
         std::any_of(bonds.begin(), bonds.end(), [&](const Link& bond) {
           const std::uint8_t other = element(bond.node);
           return (other == 8 || other == 16) && bonds_at(bond.node).size() == 1;
         });
}

bool BondChemistry::is_tertiary_amide(Joint c, Joint n) const {
  return heavy_bonds_at(n) == 3 && !is_tetrahedral(n) && is_amide(c, n);
}

bool BondChemistry::is_amide(Joint c, Joint n) const { return is_acyl(c) && bears_apart(n, c); }

bool BondChemistry::is_amidine(Joint c, Joint n) const {
  const auto bonds = bonds_at(c);
  return element(c) == 6 && bonds.size() == 3 && !is_tetrahedral(c) && !is_acyl(c) &&
         std::any_of(bonds.begin(), bonds.end(),
                     [&](const Link& bond) {
                       return bond.node != n && is_nitrogen(bond.node) &&
                              bonds_at(bond.node).size() == 2;
                     }) &&
         bears_apart(n, c);
}

bool BondChemistry::is_ring_amide(Joint c, Joint n, bool is_tertiary) const {
  const auto bonds = bonds_at(n);
  return is_nitrogen(n) && bonds.size() == 3 && is_acyl(c) &&
         heavy_bonds_at(n) >= (is_tertiary ? 3 : 2) &&
         std::any_of(
             bonds.begin(), bonds.end(),
             [&](const Link& bond) { return bond.node == c && is_ring_bond_[bond.edge]; }) &&
         !is_in_ring_up_to(largest_that_stays, c, n);
}

bool BondChemistry::is_in_ring_up_to(std::size_t most, Joint a, Joint b) const {
  std::vector<Joint> reached{a};
  std::size_t begin = 0;
  for (std::size_t depth = 1; depth < most; ++depth) {
    const std::size_t end = reached.size();
    for (; begin < end; ++begin)
      for (const Link& next : bonds_at(reached[begin])) {
        if (reached[begin] == a && next.node == b) continue;
        if (next.node == b) return true;
        if (std::find(reached.begin(), reached.end(), next.node) == reached.end())
          reached.push_back(next.node);
      }
  }
  return false;
}

/// Whether it is nitrogen with three bonds that bears heavy atoms, none of which `c` reaches
/// without it.
bool BondChemistry::bears_apart(Joint n, Joint c) const {
  const auto bonds = bonds_at(n);
  if (element(n) != 7 || bonds.size() != 3 || heavy_bonds_at(n) < 2) return false;
  const std::vector<Joint> hung = beyond(c, {n});
  return std::none_of(bonds.begin(), bonds.end(), [&](const Link& bond) {
    return bond.node != c && std::find(hung.begin(), hung.end(), bond.node) != hung.end();
  });
}

bool BondChemistry::is_acylated(Joint nitrogen) const {
  const auto bonds = bonds_at(nitrogen);
  return std::any_of(bonds.begin(), bonds.end(),
                     [&](const Link& bond) { return is_tertiary_amide(bond.node, nitrogen); });
}

bool BondChemistry::is_ester(Joint c, Joint o) const {
  const auto bonds = bonds_at(o);
  return is_acyl(c) && element(o) == 8 && bonds.size() == 2 &&
         std::none_of(bonds.begin(), bonds.end(),
                      [&](const Link& bond) { return is_hydrogen(bond.node); });
}

bool BondChemistry::donates(Joint atom) const {
  const auto bonds = bonds_at(atom);
  const bool is_polar = accepts(atom);
  return (is_polar || is_hydrogen(atom)) &&
         std::any_of(bonds.begin(), bonds.end(), [&](const Link& bond) {
           return is_polar ? is_hydrogen(bond.node) : accepts(bond.node);
         });
}

bool BondChemistry::is_amine(Joint atom) const {
  return element(atom) == 7 && bonds_at(atom).size() == 3 && is_tetrahedral(atom) &&
         !is_in_ring_of_three(atom) && !is_beside_acyl(atom);
}

bool BondChemistry::is_in_ring_of_three(Joint atom) const {
  for (const Link& one : bonds_at(atom))
    for (const Link& two : bonds_at(one.node))
      for (const Link& three : bonds_at(two.node))
        if (two.node != atom && three.node == atom) return true;
  return false;
}

std::vector<Joint> BondChemistry::beyond(Joint atom, const std::vector<Joint>& walls) const {
  std::vector<Joint> found{atom};
  std::vector<bool> is_seen(framework_.joint_count(), false);
  is_seen[atom] = true;
  for (Joint wall : walls) is_seen[wall] = true;
  for (std::size_t k = 0; k < found.size(); ++k)
    for (const Link& bond : bonds_at(found[k])) {
      if (is_seen[bond.node]) continue;
      is_seen[bond.node] = true;
      found.push_back(bond.node);
    }
  found.erase(found.begin());
  return found;
}

}  // namespace pliant
