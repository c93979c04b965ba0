// SPDX-License-Identifier: MIT
#include "pliant/model/rigidity/rigidity_network.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "pliant/base/error.hpp"
#include "pliant/molecule/planar_groups.hpp"

namespace pliant {
namespace {

constexpr std::uint8_t hinge = 5, locked = 6;
/// At atoms whose angles are free. An atom that has one bond keeps two of its six freedoms: its own
/// turning moves nothing.
constexpr std::uint8_t ball_joint = 3, length_of_end = 4, length_alone = 1;

bool is_hydrogen_bond(const MolecularContact& contact) {
  return entry(contact.kind).has_hydrogen();
}

void check(const RigidityOptions& options) {
  for (const auto& [kind, bars] : options.bars) {
    const MolecularContactKindEntry& row = entry(kind);
    const std::uint8_t least = row.has_hydrogen() ? 1 : 0;
    if (bars < least || bars > locked)
      throw OptionError("bars of " + std::string(row.plural) + ": expected " +
                        std::to_string(least) + " to 6, found " + std::to_string(bars));
  }
}

/// Kinds that are not diluted, those of most bars first.
std::vector<MolecularContactKind> fixed_kinds() {
  std::vector<MolecularContactKind> kinds;
  for (const MolecularContactKindEntry& row : molecular_contact_kinds())
    if (!row.has_hydrogen()) kinds.push_back(row.kind);
  std::stable_sort(kinds.begin(), kinds.end(),
                   [](auto one, auto other) { return entry(one).bars > entry(other).bars; });
  return kinds;
}

class NetworkMaker {
 public:
  NetworkMaker(const Structure& structure, std::span<const MolecularContact> contacts,
               const RigidityOptions& options)
      : structure_(structure),
        contacts_(contacts),
        options_(options),
        bonds_at_(structure.size(), 0),
        is_held_(structure.size(), false),
        is_free_(structure.size(), false),
        home_(structure.size(), no_bond) {}

  RigidityNetwork make() {
    check_contacts();
    network_.atoms = structure_.size();
    for (const Bond& bond : structure_.bonds) {
      ++bonds_at_[bond.a];
      ++bonds_at_[bond.b];
    }
    for (const MolecularContact& contact : contacts_)
      if (is_hydrogen_bond(contact)) is_held_[near_end(contact)] = is_held_[contact.b] = true;
    free_angles();
    add_bonds();
    add_fixed_contacts();
    add_hydrogen_bonds();
    return std::move(network_);
  }

 private:
  void check_contacts() const {
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      const MolecularContact& contact = contacts_[k];
      const std::uint32_t a = near_end(contact);
      if (a >= structure_.size() || contact.b >= structure_.size() || a == contact.b)
        throw InputError("contact " + std::to_string(k) + " joins atoms " + std::to_string(a) +
                         " and " + std::to_string(contact.b) + ": expected two of " +
                         std::to_string(structure_.size()) + " (counted from 0)");
    }
  }

  /// The hydrogen of a hydrogen bond, where there is one.
  static std::uint32_t near_end(const MolecularContact& contact) {
    const bool is_by_hydrogen =
        is_hydrogen_bond(contact) && contact.hydrogen != MolecularContact::none;
    return is_by_hydrogen ? contact.hydrogen : contact.a;
  }

  static constexpr std::uint32_t no_bond = ~std::uint32_t{0};

  void free_angles() {
    for (const std::uint32_t atom : options_.free_angles) {
      if (atom >= structure_.size())
        throw OptionError("free angles: there is no atom " + std::to_string(atom) + " among " +
                          std::to_string(structure_.size()) + " (counted from 0)");
      is_free_[atom] = true;
    }
    for (std::uint32_t k = 0; k < structure_.bonds.size(); ++k) {
      const auto [a, b] = std::pair(structure_.bonds[k].a, structure_.bonds[k].b);
      if (is_free_[a] && carries(b) && home_[a] == no_bond) home_[a] = k;
      if (is_free_[b] && carries(a) && home_[b] == no_bond) home_[b] = k;
    }
    for (const std::uint32_t atom : options_.free_angles)
      if (home_[atom] == no_bond)
        throw OptionError("free angles: " + structure_.atoms.label(atom) +
                          " has no neighbour with several bonds whose own angles are held");
  }

  bool carries(std::uint32_t atom) const { return !is_free_[atom] && bonds_at_[atom] > 1; }

  /// The bars of a bond at an atom whose angles are free; nothing for another bond.
  std::optional<std::uint8_t> bars_of_free(std::uint32_t k) const {
    const Bond& bond = structure_.bonds[k];
    if (!is_free_[bond.a] && !is_free_[bond.b]) return std::nullopt;
    if (is_free_[bond.a] && is_free_[bond.b]) return length_alone;
    const std::uint32_t point = is_free_[bond.a] ? bond.a : bond.b;
    if (home_[point] == k) return locked;
    return carries(point == bond.a ? bond.b : bond.a) ? ball_joint : length_of_end;
  }

  void add_bonds() {
    const std::vector<bool> is_locked = find_locked_bonds(structure_);
    for (std::size_t k = 0; k < structure_.bonds.size(); ++k) {
      const Bond& bond = structure_.bonds[k];
      if (const auto bars = bars_of_free(static_cast<std::uint32_t>(k))) {
        network_.edges.push_back({bond.a, bond.b, *bars});
        continue;
      }
      const bool is_at_end = bonds_at_[bond.a] == 1 || bonds_at_[bond.b] == 1;
      const bool turns = !is_locked[k] && (!is_at_end || (options_.ends_turn && is_held(bond)));
      if (turns && is_at_end) network_.turning_ends.push_back(static_cast<std::uint32_t>(k));
      network_.edges.push_back({bond.a, bond.b, turns ? hinge : locked});
    }
    network_.bonds = network_.edges.size();
  }

  /// Whether each atom of the bond that has no other bond has a hydrogen bond.
  bool is_held(const Bond& bond) const {
    return (bonds_at_[bond.a] > 1 || is_held_[bond.a]) &&
           (bonds_at_[bond.b] > 1 || is_held_[bond.b]);
  }

  void add_fixed_contacts() {
    for (const MolecularContactKind kind : fixed_kinds())
      for (std::size_t k = 0; k < contacts_.size(); ++k)
        if (contacts_[k].kind == kind && bars_of(kind) > 0) add(k);
    network_.first_hydrogen_bond = network_.edges.size();
  }

  void add_hydrogen_bonds() {
    std::vector<std::size_t> order;
    for (std::size_t k = 0; k < contacts_.size(); ++k)
      if (is_hydrogen_bond(contacts_[k])) order.push_back(k);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t x, std::size_t y) {
      return contacts_[x].energy < contacts_[y].energy;
    });
    for (const std::size_t k : order) add(k);
  }

  std::uint8_t bars_of(MolecularContactKind kind) const {
    const auto given = options_.bars.find(kind);
    return given == options_.bars.end() ? entry(kind).bars : given->second;
  }

  void add(std::size_t contact) {
    const MolecularContact& at = contacts_[contact];
    network_.edges.push_back({near_end(at), at.b, bars_of(at.kind)});
    network_.contacts.push_back(static_cast<std::uint32_t>(contact));
  }

  const Structure& structure_;
  std::span<const MolecularContact> contacts_;
  const RigidityOptions& options_;
  std::vector<std::uint32_t> bonds_at_;
  std::vector<bool> is_held_;        ///< by a hydrogen bond
  std::vector<bool> is_free_;        ///< its angles are
  std::vector<std::uint32_t> home_;  ///< of a free atom: the bond to what carries it along
  RigidityNetwork network_;
};

}  // namespace

RigidityNetwork rigidity_network(const Structure& structure,
                                 std::span<const MolecularContact> contacts,
                                 const RigidityOptions& options) {
  check(options);
  return NetworkMaker(structure, contacts, options).make();
}

}  // namespace pliant
