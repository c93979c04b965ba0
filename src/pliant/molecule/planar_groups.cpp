// SPDX-License-Identifier: MIT
#include "pliant/molecule/planar_groups.hpp"

#include <algorithm>

#include "pliant/base/grouped.hpp"

namespace pliant {
namespace {

constexpr std::uint8_t carbon = 6, nitrogen = 7, oxygen = 8, sulphur = 16;
constexpr std::uint8_t single = 1, twofold = 2, threefold = 3, aromatic = 4;
constexpr std::uint8_t not_known = 0;
/// Angles alone make a ring of so many atoms rigid.
constexpr std::size_t largest_rigid_ring = 6;
/// A nitrogen with more neighbours has no pair of electrons to share.
constexpr std::size_t most_at_nitrogen = 3;
/// Atoms with more are metals or mistakes.
constexpr std::size_t most_neighbours = 64;

struct Neighbour {
  std::uint32_t atom;
  std::uint8_t order;
};

class PlanarGroups {
 public:
  explicit PlanarGroups(const Structure& structure)
      : structure_(structure), neighbours_(structure.size(), [&](const auto& put) {
          for (const Bond& bond : structure.bonds) {
            put(bond.a, {bond.b, bond.order});
            put(bond.b, {bond.a, bond.order});
          }
        }) {}

  std::vector<std::size_t> bonds() {
    std::vector<std::size_t> found;
    for (std::size_t k = 0; k < structure_.bonds.size(); ++k) {
      const Bond& bond = structure_.bonds[k];
      if (holds(bond) && carries(bond.a) && carries(bond.b) && !is_in_rigid_ring(bond))
        found.push_back(k);
    }
    return found;
  }

  std::vector<bool> locked() const {
    std::vector<bool> is_locked;
    for (const Bond& bond : structure_.bonds)
      is_locked.push_back(bond.order == threefold || holds(bond));
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

  bool holds(const Bond& bond) const {
    if (bond.order == twofold || bond.order == aromatic) return true;
    if (bond.order != single && bond.order != not_known) return false;
    return is_amide(bond, bond.a, bond.b) || is_amide(bond, bond.b, bond.a);
  }

  bool is_amide(const Bond& bond, std::uint32_t c, std::uint32_t n) const {
    if (element(c) != carbon || element(n) != nitrogen) return false;
    if (neighbours_.at(n).size() > most_at_nitrogen) return false;
    if (bond.origin == BondOrigin::link) return true;
    const auto around = neighbours_.at(c);
    return std::any_of(around.begin(), around.end(), [&](const Neighbour& at) {
      const std::uint8_t other = element(at.atom);
      if (at.atom == n) return false;
      if (at.order == aromatic) return other == nitrogen;
      return at.order == twofold && (other == oxygen || other == sulphur || other == nitrogen);
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
