// SPDX-License-Identifier: MIT
// Contacts of molecules (noncovalent interactions, non-covalent bonds) of the kinds in
// contact_kinds.hpp. Each is held by limits that give it slack.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "pliant/framework/limits.hpp"
#include "pliant/model/contacts/contact_kinds.hpp"
#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

/// Two atoms in contact. Of a hydrogen bond or salt bridge: `a` the donor D, `b` the acceptor A,
/// `hydrogen` H and `base` B, the atom that the acceptor is bonded to. Of a metal: `a` the metal.
struct MolecularContact {
  static constexpr std::uint32_t none = ~std::uint32_t{0};
  MolecularContactKind kind = MolecularContactKind::hydrogen_bond;
  std::uint32_t a = 0, b = 0;
  std::uint32_t hydrogen = none, base = none;
  double energy = 0.0;    ///< kcal/mol, below 0; -1 for tethers, which have none of their own
  double distance = 0.0;  ///< Angstrom, a..b at the start
  double least = 0.0, most = 0.0;            ///< Angstrom, a..b is held to
  double hydrogen_most = 0.0;                ///< Angstrom, H..A; hydrogen bonds only
  double base_least = 0.0, base_most = 0.0;  ///< Angstrom, H..B; hydrogen bonds only
  friend bool operator==(const MolecularContact&, const MolecularContact&) = default;
};

/// Sets what distances of `contact` are held to, from where its atoms are now and with the slack of
/// its kind: by hydrogen D..A <= max(d0, 2.9) + slack, H..A <= max(d0, 2.0) + slack,
/// |H..B - d0| <= 0.6; both ways |a..b - d0| <= slack; below: a..b <= max(d0, `usual`) + slack.
void set_limits(MolecularContact& contact, const Structure& structure, double usual = 0.0);

/// The limits of all contacts, one group each (group k is contact k) with the contact's energy in
/// kJ/mol on each of its rows: of a hydrogen bond H..A, D..A and H..B, else a..b.
std::vector<Limit> limits_of(std::span<const MolecularContact> contacts);

/// In the order of kinds, those that are found together as one; each by a, then b, then hydrogen.
void sort(std::vector<MolecularContact>& contacts);

}  // namespace pliant
