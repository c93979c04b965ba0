// SPDX-License-Identifier: MIT
#include "pliant/model/contacts/contact_list.hpp"

#include <algorithm>
#include <array>
#include <tuple>

namespace pliant {
namespace {

using Kind = MolecularContactKind;

constexpr std::array<MolecularContactKindEntry, 4> table{
    {{Kind::hydrogen_bond, "hydrogen_bond", "donor, hydrogen and acceptor, by their energy",
      LimitKind::hydrogen_bond},
     {Kind::salt_bridge, "salt_bridge", "a hydrogen bond between charged groups",
      LimitKind::hydrogen_bond},
     {Kind::hydrophobic, "hydrophobic", "two C or S near each other without polar neighbours",
      LimitKind::hydrophobic},
     {Kind::metal, "metal", "a metal without bonds and an N, O or S beside it", LimitKind::given}}};

bool is_hydrogen_bond(const MolecularContact& contact) {
  return contact.hydrogen != MolecularContact::none;
}

}  // namespace

std::span<const MolecularContactKindEntry> molecular_contact_kinds() { return table; }

std::string_view name(MolecularContactKind kind) {
  return table[static_cast<std::size_t>(kind)].name;
}

void set_limits(MolecularContact& contact, const Structure& structure, double usual,
                const ContactSlack& slack) {
  const auto apart = [&](std::uint32_t a, std::uint32_t b) {
    return distance(structure.positions[a], structure.positions[b]);
  };
  contact.distance = apart(contact.a, contact.b);
  contact.least = 0.0;
  if (is_hydrogen_bond(contact)) {
    const double h = apart(contact.hydrogen, contact.b),
                 base = apart(contact.hydrogen, contact.base);
    contact.most = std::max(contact.distance, slack.usual_donor) + slack.hydrogen_bond;
    contact.hydrogen_most = std::max(h, slack.usual_hydrogen) + slack.hydrogen_bond;
    contact.base_least = std::max(0.0, base - slack.base);
    contact.base_most = base + slack.base;
  } else if (contact.kind == Kind::metal) {
    contact.least = std::max(0.0, contact.distance - slack.metal);
    contact.most = contact.distance + slack.metal;
  } else {
    contact.most = std::max(contact.distance, usual) + slack.tether;
  }
}

std::vector<Limit> limits_of(std::span<const MolecularContact> contacts) {
  std::vector<Limit> limits;
  for (std::uint32_t k = 0; k < contacts.size(); ++k) {
    const MolecularContact& c = contacts[k];
    const LimitKind kind = table[static_cast<std::size_t>(c.kind)].limit;
    const double energy = c.energy * kj_per_kcal;
    if (is_hydrogen_bond(c))
      limits.push_back({c.hydrogen, c.b, 0.0, c.hydrogen_most, kind, energy, k});
    limits.push_back({c.a, c.b, c.least, c.most, kind, energy, k});
    if (is_hydrogen_bond(c))
      limits.push_back({c.hydrogen, c.base, c.base_least, c.base_most, kind, energy, k});
  }
  return limits;
}

void sort(std::vector<MolecularContact>& contacts) {
  using Kind = MolecularContactKind;
  const auto rank = [](const MolecularContact& contact) {
    return contact.kind == Kind::salt_bridge ? Kind::hydrogen_bond : contact.kind;
  };
  std::sort(contacts.begin(), contacts.end(), [&](const auto& one, const auto& other) {
    if (rank(one) != rank(other)) return rank(one) < rank(other);
    return std::tie(one.a, one.b, one.hydrogen) < std::tie(other.a, other.b, other.hydrogen);
  });
}

}  // namespace pliant
