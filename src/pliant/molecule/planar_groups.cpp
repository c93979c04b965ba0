// SPDX-License-Identifier: MIT
#include "pliant/molecule/planar_groups.hpp"

#include <algorithm>

#include "pliant/base/graphs/grouped.hpp"
#include "pliant/molecule/aromaticity.hpp"

namespace pliant {
namespace {

constexpr std::uint8_t hydrogen = 1, carbon = 6, nitrogen = 7, oxygen = 8, sulphur = 16;
constexpr std::uint8_t twofold = 2, threefold = 3, aromatic = 4;
/// Angles alone make a ring of so many atoms rigid.
constexpr std::size_t largest_rigid_ring = 6;
/// A nitrogen with more neighbours has no pair of electrons to share.
constexpr std::size_t most_at_nitrogen = 3;
/// Atoms with more are metals or mistakes.
constexpr std::size_t most_neighbours = 64;

struct Neighbour {
  std::uint32_t atom;
  std::uint8_t order;
  bool is_aromatic;  ///< of an aromatic ring
};

class PlanarGroups {
 public:
  explicit PlanarGroups(const Structure& structure)
      : structure_(structure),
        is_aromatic_(find_aromatic_bonds(structure)),
        neighbours_(structure.size(), [&](const auto& put) {
          for (std::size_t k = 0; k < structure.bonds.size(); ++k) {
            const Bond& bond = structure.bonds[k];
            put(bond.a, {bond.b, bond.order, is_aromatic_[k]});
            put(bond.b, {bond.a, bond.order, is_aromatic_[k]});
          }
        }) {}

  std::vector<std::size_t> bonds() {
    std::vector<std::size_t> found;
    for (std::size_t k = 0; k < structure_.bonds.size(); ++k) {
      const Bond& bond = structure_.bonds[k];
      if (holds(k) && carries(bond.a) && carries(bond.b) && !is_in_rigid_ring(bond))
        found.push_back(k);
    }
    return found;
  }

  std::vector<bool> locked() const {
    std::vector<bool> is_locked;
    for (std::size_t k = 0; k < structure_.bonds.size(); ++k)
      is_locked.push_back(structure_.bonds[k].order == threefold || holds(k));
    return is_locked;
  }

  /// More than one bar would depend on others in the plane, and make Newton's method slow.
  void add_bar(const Bond& bond, std::vector<Bar>& bars) const {
    Bar longest;
    double most = -1.0;
    for (const Neighbour& one : neighbours_.at(bond.a))
      for (const Neighbour& other : neighbours_.at(bond.b)) {
        const auto [a, b] = std::minmax(one.atom, other.atom);
        if (one.atom == bond.b || other.atom == bond.a || are_near(a, b)) continue;
        const double length = distance(structure_.positions[a], structure_.positions[b]);
        if (!(length > most)) continue;
        most = length;
        longest = {a, b};
      }
    if (most >= 0.0) bars.push_back(longest);
  }

 private:
  std::uint8_t element(std::uint32_t atom) const { return structure_.atoms.elements[atom]; }

  bool carries(std::uint32_t atom) const {
    const std::size_t count = neighbours_.at(atom).size();
    return count > 1 && count <= most_neighbours;
  }

  bool holds(std::size_t place) const {
    const Bond& bond = structure_.bonds[place];
    if (is_aromatic_[place] || bond.order == aromatic) return true;
    if (bond.order == twofold && !is_double_by_drawing(bond)) return true;
    if (bond.order == threefold) return false;
    return is_amide(bond, bond.a, bond.b) || is_amide(bond, bond.b, bond.a);
  }

  bool is_at_aromatic_ring(std::uint32_t atom) const {
    const auto around = neighbours_.at(atom);
    return std::any_of(around.begin(), around.end(),
                       [](const Neighbour& at) { return at.is_aromatic; });
  }

  /// Whether another form of an aromatic ring has a single bond there: between two such rings
  /// (biphenylene), and to N+ that a ring bears (an amine of a charged ring).
  bool is_double_by_drawing(const Bond& bond) const {
    const bool at_a = is_at_aromatic_ring(bond.a), at_b = is_at_aromatic_ring(bond.b);
    const auto is_iminium = [&](std::uint32_t atom) {
      return element(atom) == nitrogen && !structure_.charges.empty() &&
             structure_.charges[atom] > 0;
    };
    return (at_a && at_b) || (at_a && is_iminium(bond.b)) || (at_b && is_iminium(bond.a));
  }

  bool is_amide(const Bond& bond, std::uint32_t c, std::uint32_t n) const {
    if (element(c) != carbon || element(n) != nitrogen) return false;
    if (neighbours_.at(n).size() > most_at_nitrogen) return false;
    if (bond.origin == BondOrigin::link) return true;
    // Of modified residues no orders are known.
    const bool is_link = structure_.atoms.residue_of[c] != structure_.atoms.residue_of[n];
    const auto around = neighbours_.at(c);
    return std::any_of(around.begin(), around.end(), [&](const Neighbour& at) {
      const std::uint8_t other = element(at.atom);
      if (at.atom == n) return false;
      if (at.is_aromatic) return other == nitrogen && bears_hydrogens_alone(n, c);
      if (at.order == aromatic) return other == nitrogen;
      if (at.order == 0 && is_link && other == oxygen) return neighbours_.at(at.atom).size() == 1;
      return at.order == twofold && (other == oxygen || other == sulphur || other == nitrogen);
    });
  }

  /// Whether n bears only hydrogens besides its bond to `c`.
  bool bears_hydrogens_alone(std::uint32_t n, std::uint32_t c) const {
    const auto around = neighbours_.at(n);
    return std::all_of(around.begin(), around.end(), [&](const Neighbour& at) {
      return at.atom == c || element(at.atom) == hydrogen;
    });
  }

  /// Goes outward from one end; whether the other is met over at most five bonds more.
  bool is_in_rigid_ring(const Bond& bond) {
    reached_.assign(1, bond.a);
    for (std::size_t level = 1, from = 0; level < largest_rigid_ring; ++level) {
      const std::size_t to = reached_.size();
      for (; from < to; ++from)
        for (const Neighbour& at : neighbours_.at(reached_[from])) {
          const bool is_bond = reached_[from] == bond.a && at.atom == bond.b;
          if (at.atom == bond.b && !is_bond) return true;
          if (!is_bond && std::find(reached_.begin(), reached_.end(), at.atom) == reached_.end())
            reached_.push_back(at.atom);
        }
    }
    return false;
  }

  /// Whether they are bonded, or bonded to one atom.
  bool are_near(std::uint32_t a, std::uint32_t b) const {
    if (a == b) return true;
    const auto around_b = neighbours_.at(b);
    const auto is_at_b = [&](std::uint32_t atom) {
      return std::any_of(around_b.begin(), around_b.end(),
                         [&](const Neighbour& at) { return at.atom == atom; });
    };
    const auto around_a = neighbours_.at(a);
    return is_at_b(a) || std::any_of(around_a.begin(), around_a.end(),
                                     [&](const Neighbour& at) { return is_at_b(at.atom); });
  }

  const Structure& structure_;
  std::vector<bool> is_aromatic_;  ///< (M)
  Grouped<Neighbour, std::size_t> neighbours_;
  std::vector<std::uint32_t> reached_;
};

}  // namespace

std::vector<std::size_t> find_planar_bonds(const Structure& structure) {
  return PlanarGroups(structure).bonds();
}

std::vector<bool> find_locked_bonds(const Structure& structure) {
  return PlanarGroups(structure).locked();
}

std::vector<Bar> find_planar_bars(const Structure& structure) {
  PlanarGroups groups(structure);
  std::vector<Bar> bars;
  for (const std::size_t k : groups.bonds()) groups.add_bar(structure.bonds[k], bars);
  const auto before = [](Bar x, Bar y) { return x.a != y.a ? x.a < y.a : x.b < y.b; };
  std::sort(bars.begin(), bars.end(), before);
  bars.erase(std::unique(bars.begin(), bars.end()), bars.end());
  return bars;
}

}  // namespace pliant
