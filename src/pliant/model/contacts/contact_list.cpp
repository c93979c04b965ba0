// SPDX-License-Identifier: MIT
#include "pliant/model/contacts/contact_list.hpp"

#include <algorithm>
#include <tuple>

namespace pliant {
namespace {

// Angstrom: H..A and D..A of a usual hydrogen bond, and how far H..B may change.
constexpr double usual_hydrogen = 2.0, usual_donor = 2.9, base_slack = 0.6;

/// The first kind that is found together with this one.
std::size_t rank_of(MolecularContactKind kind) {
  const auto kinds = molecular_contact_kinds();
  return static_cast<std::size_t>(
      std::find_if(kinds.begin(), kinds.end(),
                   [&](const auto& row) { return row.find == entry(kind).find; }) -
      kinds.begin());
}

}  // namespace

void set_limits(MolecularContact& contact, const Structure& structure, double usual) {
  const MolecularContactKindEntry& row = entry(contact.kind);
  const auto apart = [&](std::uint32_t a, std::uint32_t b) {
    return distance(structure.positions[a], structure.positions[b]);
  };
  contact.distance = apart(contact.a, contact.b);
  contact.least = 0.0;
  const bool lacks_hydrogen = row.has_hydrogen() && contact.hydrogen == MolecularContact::none;
  switch (lacks_hydrogen ? ContactHold::below : row.hold) {
    case ContactHold::by_hydrogen: {
      const double h = apart(contact.hydrogen, contact.b),
                   base = apart(contact.hydrogen, contact.base);
      contact.most = std::max(contact.distance, usual_donor) + row.slack;
      contact.hydrogen_most = std::max(h, usual_hydrogen) + row.slack;
      contact.base_least = std::max(0.0, base - base_slack);
      contact.base_most = base + base_slack;
      break;
    }
    case ContactHold::both_ways:
      contact.least = std::max(0.0, contact.distance - row.slack);
      contact.most = contact.distance + row.slack;
      break;
    case ContactHold::below:
      contact.most = std::max(contact.distance, usual) + row.slack;
      break;
  }
}

std::vector<Limit> limits_of(std::span<const MolecularContact> contacts) {
  std::vector<Limit> limits;
  for (std::uint32_t k = 0; k < contacts.size(); ++k) {
    const MolecularContact& c = contacts[k];
    const LimitKind kind = entry(c.kind).limit;
    const double energy = c.energy * kj_per_kcal;
    const bool has_hydrogen = c.hydrogen != MolecularContact::none;
    if (has_hydrogen) limits.push_back({c.hydrogen, c.b, 0.0, c.hydrogen_most, kind, energy, k});
    limits.push_back({c.a, c.b, c.least, c.most, kind, energy, k});
    if (has_hydrogen)
      limits.push_back({c.hydrogen, c.base, c.base_least, c.base_most, kind, energy, k});
  }
  return limits;
}

void sort(std::vector<MolecularContact>& contacts) {
  std::vector<std::size_t> ranks;
  for (const auto& row : molecular_contact_kinds()) ranks.push_back(rank_of(row.kind));
  const auto rank = [&](const MolecularContact& contact) {
    return ranks[static_cast<std::size_t>(contact.kind)];
  };
  std::sort(contacts.begin(), contacts.end(), [&](const auto& one, const auto& other) {
    if (rank(one) != rank(other)) return rank(one) < rank(other);
    return std::tie(one.a, one.b, one.hydrogen) < std::tie(other.a, other.b, other.hydrogen);
  });
}

}  // namespace pliant
