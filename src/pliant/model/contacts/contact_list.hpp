// SPDX-License-Identifier: MIT
// Contacts of molecules (noncovalent interactions, non-covalent bonds): hydrogen bonds, salt
// bridges, hydrophobic tethers, metals. Each is held by limits that give it slack.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "pliant/framework/limits.hpp"
#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

enum class MolecularContactKind : std::uint8_t { hydrogen_bond, salt_bridge, hydrophobic, metal };

/// One row of the table of kinds of contact.
struct MolecularContactKindEntry {
  MolecularContactKind kind;
  std::string_view name;     ///< "hydrogen_bond"
  std::string_view summary;  ///< one line for help
  LimitKind limit;           ///< what its limits are recorded as
};

/// All kinds, in the order of their numbers.
std::span<const MolecularContactKindEntry> molecular_contact_kinds();
std::string_view name(MolecularContactKind kind);

/// Angstrom: how much further than at the start (or than a usual contact) two atoms may be.
struct ContactSlack {
  double usual_hydrogen = 2.0, usual_donor = 2.9;  ///< H..A and D..A of a usual hydrogen bond
  double hydrogen_bond = 0.2;
  double base = 0.6;    ///< H..B, both ways
  double tether = 0.5;  ///< beyond the sum of van der Waals radii, or the start
  double metal = 0.2;   ///< both ways
};

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

/// Sets what distances of `contact` are held to, from where its atoms are now:
/// D..A <= max(d0, 2.9) + 0.2, H..A <= max(d0, 2.0) + 0.2, |H..B - d0| <= 0.6;
/// tether <= max(d0, `usual`) + 0.5; |metal - d0| <= 0.2.
void set_limits(MolecularContact& contact, const Structure& structure, double usual = 0.0,
                const ContactSlack& slack = {});

/// The limits of all contacts, one group each (group k is contact k) with the contact's energy in
/// kJ/mol on each of its rows: of a hydrogen bond H..A, D..A and H..B, else a..b.
std::vector<Limit> limits_of(std::span<const MolecularContact> contacts);

/// Hydrogen bonds with salt bridges, then tethers, then metals, as they are found; each by a, then
/// b, then hydrogen.
void sort(std::vector<MolecularContact>& contacts);

}  // namespace pliant
