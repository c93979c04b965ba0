// SPDX-License-Identifier: MIT
// Finds the contacts that two structures of one molecule share.
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

/// Matched residues of two structures, by their indices.
struct ResiduePairing {
  std::vector<std::uint32_t> ours, theirs;  ///< (M)
};

/// `matched`, and besides residues with the same chain, number and name in both: ligands, metals.
ResiduePairing with_ligands(const Structure& ours, const Structure& theirs, ResiduePairing matched);

/// An atom in both structures: the index of its residue's match, and its name.
using MatchedName = std::pair<std::uint32_t, std::string_view>;

/// Atoms of matched residues by name. The structure must outlive it and not move.
class MatchedAtoms {
 public:
  MatchedAtoms(const Structure& structure, std::span<const std::uint32_t> residues);

  /// Nothing for atoms of other residues, and for those whose name a later atom of the residue has.
  std::optional<MatchedName> name_of(std::uint32_t atom) const;
  std::optional<std::uint32_t> atom_of(const MatchedName& name) const;
  /// The name of the atom that a rotation of the side chain would exchange with it: OD1 of ASP for
  /// OD2.
  std::optional<MatchedName> name_alike(std::uint32_t atom) const;

 private:
  const Structure& structure_;
  std::vector<std::uint32_t> match_of_;  ///< (R)
  std::map<MatchedName, std::uint32_t> atoms_;
};

/// The contacts of two structures, compared. Contacts of unmatched atoms are in none of the lists.
struct SharedContacts {
  std::vector<MolecularContact> ours, theirs;            ///< contacts that both have
  std::vector<MolecularContact> only_ours, only_theirs;  ///< contacts that only one has
};

SharedContacts share_contacts(std::span<const MolecularContact> ours, const MatchedAtoms& our_atoms,
                              std::span<const MolecularContact> theirs,
                              const MatchedAtoms& their_atoms);

/// How far the length of a contact is outside its interval (Angstrom); 0 within.
double outside(const MolecularContact& contact, std::span<const Vec3> positions);

}  // namespace pliant
