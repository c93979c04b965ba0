// SPDX-License-Identifier: MIT
// Contacts of two structures of one molecule: which of them both have.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "pliant/model/contacts/contact_list.hpp"
#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

/// Which residue of one structure is which of the other, by their indices.
struct ResiduePairing {
  std::vector<std::uint32_t> ours, theirs;  ///< (M)
};

/// The same, and besides residues that have the same chain, number and name in both: ligands,
/// metals.
ResiduePairing with_ligands(const Structure& ours, const Structure& theirs, ResiduePairing matched);

/// An atom as both structures call it: which match its residue is, and its name there.
using MatchedName = std::pair<std::uint32_t, std::string_view>;

/// Atoms of matched residues by name. The structure must outlive it, where it is.
class MatchedAtoms {
 public:
  MatchedAtoms(const Structure& structure, std::span<const std::uint32_t> residues);

  /// Nothing of atoms of other residues, and of those whose name a later atom of theirs has.
  std::optional<MatchedName> name_of(std::uint32_t atom) const;
  std::optional<std::uint32_t> atom_of(const MatchedName& name) const;
  /// The same name for atoms that a turn of the side chain would swap: OD1 of ASP for its OD2.
  std::optional<MatchedName> name_alike(std::uint32_t atom) const;

 private:
  const Structure& structure_;
  std::vector<std::uint32_t> match_of_;  ///< (R)
  std::map<MatchedName, std::uint32_t> atoms_;
};

/// The contacts of two structures, told apart. Those of atoms that are not matched are in none.
struct SharedContacts {
  std::vector<MolecularContact> ours, theirs;            ///< that both have
  std::vector<MolecularContact> only_ours, only_theirs;  ///< that one has alone
};

SharedContacts share_contacts(std::span<const MolecularContact> ours, const MatchedAtoms& our_atoms,
                              std::span<const MolecularContact> theirs,
                              const MatchedAtoms& their_atoms);

/// How far the distance of a contact is outside its interval (Angstrom), 0 within.
double outside(const MolecularContact& contact, std::span<const Vec3> positions);

}  // namespace pliant
