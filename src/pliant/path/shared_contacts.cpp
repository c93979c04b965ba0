// SPDX-License-Identifier: MIT
#include "pliant/path/shared_contacts.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <tuple>

namespace pliant {
namespace {

constexpr std::uint32_t no_match = ~std::uint32_t{0};

/// Two atoms of a residue that are alike, and which name stands for both.
struct AlikeAtoms {
  std::string_view residue, atom, stands;
};

constexpr AlikeAtoms alike_atoms[] = {
    {"ASP", "OD2", "OD1"}, {"GLU", "OE2", "OE1"}, {"ARG", "NH2", "NH1"}, {"PHE", "CD2", "CD1"},
    {"PHE", "CE2", "CE1"}, {"TYR", "CD2", "CD1"}, {"TYR", "CE2", "CE1"}, {"VAL", "CG2", "CG1"},
    {"LEU", "CD2", "CD1"}, {"ILE", "CD", "CD1"}};

std::string_view standing_for(std::string_view residue, std::string_view atom) {
  for (const AlikeAtoms& row : alike_atoms)
    if (row.residue == residue && row.atom == atom) return row.stands;
  return atom;
}

/// What a contact joins, in either order.
struct ContactKey {
  MolecularContactKind kind;
  MatchedName one, other;
  friend auto operator<=>(const ContactKey&, const ContactKey&) = default;
};

std::optional<ContactKey> key_of(const MolecularContact& contact, const MatchedAtoms& atoms) {
  const auto a = atoms.name_alike(contact.a), b = atoms.name_alike(contact.b);
  if (!a || !b) return std::nullopt;
  return ContactKey{contact.kind, std::min(*a, *b), std::max(*a, *b)};
}

std::set<ContactKey> keys_of(std::span<const MolecularContact> contacts,
                             const MatchedAtoms& atoms) {
  std::set<ContactKey> keys;
  for (const MolecularContact& contact : contacts)
    if (const auto key = key_of(contact, atoms)) keys.insert(*key);
  return keys;
}

/// Puts each contact to those that the other structure has as well, or to those that it has not.
void split(std::span<const MolecularContact> contacts, const MatchedAtoms& atoms,
           const std::set<ContactKey>& others, std::vector<MolecularContact>& shared,
           std::vector<MolecularContact>& only) {
  for (const MolecularContact& contact : contacts)
    if (const auto key = key_of(contact, atoms))
      (others.contains(*key) ? shared : only).push_back(contact);
}

/// Residues by chain, number and name; those that have atoms.
auto by_label(const Structure& structure) {
  std::map<std::tuple<std::string_view, std::int64_t, char, std::string_view>, std::uint32_t> found;
  for (std::uint32_t residue : structure.atoms.residue_of) {
    const Residue& one = structure.atoms.residues[residue];
    found[{one.chain, one.number, one.insertion_code, one.name}] = residue;
  }
  return found;
}

}  // namespace

ResiduePairing with_ligands(const Structure& ours, const Structure& theirs,
                            ResiduePairing matched) {
  const std::set<std::uint32_t> known(matched.ours.begin(), matched.ours.end());
  const std::set<std::uint32_t> known_there(matched.theirs.begin(), matched.theirs.end());
  const auto there = by_label(theirs);
  for (const auto& [label, residue] : by_label(ours)) {
    const auto other = there.find(label);
    if (known.contains(residue) || other == there.end() || known_there.contains(other->second))
      continue;
    matched.ours.push_back(residue);
    matched.theirs.push_back(other->second);
  }
  return matched;
}

MatchedAtoms::MatchedAtoms(const Structure& structure, std::span<const std::uint32_t> residues)
    : structure_(structure), match_of_(structure.atoms.residues.size(), no_match) {
  for (std::uint32_t k = 0; k < residues.size(); ++k) match_of_[residues[k]] = k;
  for (std::uint32_t atom = 0; atom < structure.size(); ++atom) {
    const std::uint32_t match = match_of_[structure.atoms.residue_of[atom]];
    if (match != no_match) atoms_[{match, structure.atoms.names[atom]}] = atom;
  }
}

std::optional<MatchedName> MatchedAtoms::name_of(std::uint32_t atom) const {
  const std::uint32_t match = match_of_[structure_.atoms.residue_of[atom]];
  if (match == no_match) return std::nullopt;
  const MatchedName name{match, structure_.atoms.names[atom]};
  if (atoms_.at(name) != atom) return std::nullopt;
  return name;
}

std::optional<std::uint32_t> MatchedAtoms::atom_of(const MatchedName& name) const {
  const auto found = atoms_.find(name);
  if (found == atoms_.end()) return std::nullopt;
  return found->second;
}

std::optional<MatchedName> MatchedAtoms::name_alike(std::uint32_t atom) const {
  auto name = name_of(atom);
  const AtomTable& atoms = structure_.atoms;
  if (name) name->second = standing_for(atoms.residues[atoms.residue_of[atom]].name, name->second);
  return name;
}

SharedContacts share_contacts(std::span<const MolecularContact> ours, const MatchedAtoms& our_atoms,
                              std::span<const MolecularContact> theirs,
                              const MatchedAtoms& their_atoms) {
  SharedContacts found;
  split(ours, our_atoms, keys_of(theirs, their_atoms), found.ours, found.only_ours);
  split(theirs, their_atoms, keys_of(ours, our_atoms), found.theirs, found.only_theirs);
  return found;
}

double outside(const MolecularContact& contact, std::span<const Vec3> positions) {
  const double apart = distance(positions[contact.a], positions[contact.b]);
  return std::max({0.0, apart - contact.most, contact.least - apart});
}

}  // namespace pliant
