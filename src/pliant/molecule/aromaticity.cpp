// SPDX-License-Identifier: MIT
#include "pliant/molecule/aromaticity.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "pliant/base/graphs/graph.hpp"
#include "pliant/base/graphs/grouped.hpp"

namespace pliant {
namespace {

constexpr std::uint8_t carbon = 6, nitrogen = 7, oxygen = 8, sulphur = 16;
constexpr std::uint8_t twofold = 2, threefold = 3, aromatic = 4;
constexpr std::uint8_t not_known = 0;
constexpr std::size_t smallest_ring = 5, largest_ring = 7;
/// More bonds leave no orbital for pi electrons.
constexpr std::size_t most_bonds = 3;
constexpr std::array<std::uint8_t, 5> with_lone_pairs{nitrogen, oxygen, sulphur, 34, 52};

struct Ring {
  std::vector<std::uint32_t> bonds;  ///< ascending
};

/// Electrons of each atom that can be in an aromatic ring.
class PiElectrons {
 public:
  PiElectrons(const Structure& structure, const Graph& graph)
      : structure_(structure), graph_(graph), blocks_(find_blocks(graph)) {
    for (std::uint32_t atom = 0; atom < structure.size(); ++atom) of_atom_.push_back(count(atom));
  }

  std::optional<int> at(std::uint32_t atom) const { return of_atom_[atom]; }
  bool is_in_ring(std::uint32_t bond) const { return !blocks_.is_bridge[bond]; }

 private:
  struct Orders {
    bool is_in_ring = false, is_known = true, stated = false, inside = false;
    int outside = 0;  ///< double bonds out of the rings
    bool to_polar = false;
  };

  std::uint8_t element(std::uint32_t atom) const { return structure_.atoms.elements[atom]; }

  int charge(std::uint32_t atom) const {
    return structure_.charges.empty() ? 0 : structure_.charges[atom];
  }

  Orders orders_at(std::uint32_t atom) const {
    Orders found;
    for (const Link& link : graph_.at(atom)) {
      const std::uint8_t order = structure_.bonds[link.edge].order;
      const bool is_in_ring = this->is_in_ring(link.edge);
      found.is_in_ring |= is_in_ring;
      found.is_known &= order != not_known;
      found.stated |= order == aromatic;
      if (order != twofold && order != threefold) continue;
      found.inside |= is_in_ring;
      if (is_in_ring) continue;
      ++found.outside;
      const std::uint8_t other = element(link.node);
      found.to_polar |= other == oxygen || other == nitrogen || other == sulphur;
    }
    return found;
  }

  std::optional<int> count(std::uint32_t atom) const {
    const std::size_t bonds = graph_.at(atom).size();
    if (bonds < 2 || bonds > most_bonds) return std::nullopt;
    const Orders orders = orders_at(atom);
    if (!orders.is_in_ring || !orders.is_known) return std::nullopt;
    if (element(atom) == carbon) return of_carbon(orders, charge(atom));
    if (orders.inside) return 1;
    if (orders.outside > 0) return std::nullopt;
    return of_hetero(atom, orders, bonds);
  }

  static std::optional<int> of_carbon(const Orders& orders, int charge) {
    if (orders.outside > 0) return orders.to_polar ? std::optional(0) : std::nullopt;
    if (orders.inside || orders.stated) return 1;
    if (charge == 0) return std::nullopt;
    return charge < 0 ? 2 : 0;
  }

  /// Nitrogen of aromatic bonds that has two of them alone is a pyridine's.
  std::optional<int> of_hetero(std::uint32_t atom, const Orders& orders, std::size_t bonds) const {
    const std::uint8_t own = element(atom);
    const int charged = charge(atom);
    if (orders.stated && (charged > 0 || (own == nitrogen && bonds == 2 && charged == 0))) return 1;
    const bool has_pair =
        std::find(with_lone_pairs.begin(), with_lone_pairs.end(), own) != with_lone_pairs.end();
    if (!has_pair || charged > 0 || (own != nitrogen && bonds > 2)) return std::nullopt;
    return 2;
  }

  const Structure& structure_;
  const Graph& graph_;
  Blocks blocks_;
  std::vector<std::optional<int>> of_atom_;
};

/// Rings of atoms that have a count, without chords.
class RingSearch {
 public:
  RingSearch(const Graph& graph, const PiElectrons& electrons)
      : graph_(graph), electrons_(electrons) {}

  std::vector<Ring> find() {
    for (std::uint32_t atom = 0; atom < graph_.node_count(); ++atom) {
      if (!electrons_.at(atom)) continue;
      atoms_.assign(1, atom);
      bonds_.clear();
      go_on();
    }
    return std::move(rings_);
  }

 private:
  /// Goes from a ring's lowest atom towards the lower of the two beside it: each ring once. What
  /// would go on from an atom that is bonded to the first has a chord.
  void go_on() {
    const auto links = graph_.at(atoms_.back());
    const auto closing = std::find_if(links.begin(), links.end(), [&](const Link& link) {
      return link.node == atoms_.front() && atoms_.size() > 2;
    });
    if (closing != links.end()) {
      if (atoms_.size() >= smallest_ring && atoms_[1] < atoms_.back()) add(closing->edge);
      return;
    }
    if (atoms_.size() == largest_ring) return;
    for (const Link& link : links)
      if (link.node > atoms_.front() && extends(link.node)) go_on_to(link);
  }

  void go_on_to(const Link& link) {
    atoms_.push_back(link.node);
    bonds_.push_back(link.edge);
    go_on();
    atoms_.pop_back();
    bonds_.pop_back();
  }

  /// Whether the atom counts, and is bonded to none of the way but its last and its first.
  bool extends(std::uint32_t atom) const {
    if (!electrons_.at(atom)) return false;
    const auto links = graph_.at(atom);
    const auto is_at = [&](std::uint32_t one) {
      return std::any_of(links.begin(), links.end(),
                         [&](const Link& link) { return link.node == one; });
    };
    for (std::size_t k = 1; k + 1 < atoms_.size(); ++k)
      if (atoms_[k] == atom || is_at(atoms_[k])) return false;
    return true;
  }

  void add(std::uint32_t last) {
    Ring ring{bonds_};
    ring.bonds.push_back(last);
    std::sort(ring.bonds.begin(), ring.bonds.end());
    rings_.push_back(std::move(ring));
  }

  const Graph& graph_;
  const PiElectrons& electrons_;
  std::vector<std::uint32_t> atoms_, bonds_;
  std::vector<Ring> rings_;
};

class Aromaticity {
 public:
  explicit Aromaticity(const Structure& structure)
      : structure_(structure),
        graph_(structure.size(), structure.bonds),
        electrons_(structure, graph_) {}

  std::vector<bool> find() {
    for (std::uint32_t k = 0; k < structure_.bonds.size(); ++k)
      found_.push_back(structure_.bonds[k].order == aromatic && electrons_.is_in_ring(k));
    rings_ = RingSearch(graph_, electrons_).find();
    rings_at_ = Grouped<std::uint32_t>(structure_.bonds.size(), [&](const auto& put) {
      for (std::uint32_t k = 0; k < rings_.size(); ++k)
        for (const std::uint32_t bond : rings_[k].bonds) put(bond, k);
    });
    for (std::uint32_t k = 0; k < rings_.size(); ++k) look_at({k});
    return std::move(found_);
  }

 private:
  static constexpr std::size_t most_together = 3;

  /// Rings that are not aromatic alone may be so together: azulene, indolizine.
  void look_at(const std::vector<std::uint32_t>& together) {
    const std::vector<std::uint32_t> around = perimeter(together);
    if (is_aromatic(around)) {
      for (const std::uint32_t bond : around) found_[bond] = true;
      return;
    }
    if (together.size() == most_together) return;
    for (const std::uint32_t next : beside(together)) {
      std::vector<std::uint32_t> more = together;
      more.push_back(next);
      look_at(more);
    }
  }

  std::vector<std::uint32_t> beside(const std::vector<std::uint32_t>& together) const {
    std::vector<std::uint32_t> found;
    for (const std::uint32_t ring : together)
      for (const std::uint32_t bond : rings_[ring].bonds)
        for (const std::uint32_t other : rings_at_.at(bond))
          if (std::find(together.begin(), together.end(), other) == together.end())
            found.push_back(other);
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

  /// Bonds of one of the rings only.
  std::vector<std::uint32_t> perimeter(const std::vector<std::uint32_t>& together) const {
    std::vector<std::uint32_t> bonds;
    for (const std::uint32_t ring : together)
      for (const std::uint32_t bond : rings_[ring].bonds) {
        const auto met = std::find(bonds.begin(), bonds.end(), bond);
        if (met == bonds.end())
          bonds.push_back(bond);
        else
          bonds.erase(met);
      }
    return bonds;
  }

  bool is_aromatic(const std::vector<std::uint32_t>& around) const {
    std::vector<std::uint32_t> atoms;
    for (const std::uint32_t bond : around)
      atoms.insert(atoms.end(), {structure_.bonds[bond].a, structure_.bonds[bond].b});
    std::sort(atoms.begin(), atoms.end());
    atoms.erase(std::unique(atoms.begin(), atoms.end()), atoms.end());
    int sum = 0;
    for (const std::uint32_t atom : atoms) sum += *electrons_.at(atom);
    return atoms.size() == around.size() && sum % 4 == 2;
  }

  const Structure& structure_;
  Graph graph_;
  PiElectrons electrons_;
  std::vector<Ring> rings_;
  Grouped<std::uint32_t> rings_at_;  ///< of each bond
  std::vector<bool> found_;
};

}  // namespace

std::vector<bool> find_aromatic_bonds(const Structure& structure) {
  return Aromaticity(structure).find();
}

}  // namespace pliant
