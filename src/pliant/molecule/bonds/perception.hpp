// SPDX-License-Identifier: MIT
// The steps of bond perception and what they share. Internal: users call bonds.hpp.
#pragma once

#include <string>
#include <vector>

#include "pliant/molecule/bonds/bond_options.hpp"
#include "pliant/molecule/structure/residue_templates.hpp"
#include "pliant/molecule/structure/structure.hpp"

namespace pliant::perception {

/// The atoms [first, last) of one residue. A residue of the file gives several pieces when its
/// names repeat: waters, and residues that all have one number.
struct ResiduePiece {
  std::uint32_t first = 0, last = 0;
  const ResidueTemplate* shape = nullptr;  ///< null where the residue is unknown
};

/// Counts one kind of oddity and keeps its first case, to report it once.
struct Tally {
  std::size_t count = 0;
  std::string first;

  /// Counts; `describe` is called for the first case only.
  template <class Describe>
  void add(const Describe& describe) {
    if (count++ == 0) first = describe();
  }
};

/// Data that the steps of perception pass on.
struct Perception {
  const Structure& structure;
  const BondOptions& options;
  std::vector<AtomKey> keys;         ///< (N) names in one spelling
  std::vector<bool> excluded;        ///< (N) keeps only the bonds of the file
  std::vector<bool> settled;         ///< (N) a template gives all bonds within the residue
  std::vector<ResiduePiece> pieces;  ///< in the order of the atoms
  std::vector<Bond> bonds;  ///< those of the file, then those of each step; may repeat pairs
  Tally unplaced;           ///< atoms with placeholder positions
  Tally repeated;           ///< atoms at the position of an atom of the same name
  Tally stretched;          ///< template bonds that are too long
  std::vector<Bond> stretched_bonds;  ///< these bonds
  std::vector<Bond> parted_links;     ///< consecutive pieces whose link is too long
  Tally crowded;                      ///< atoms too close to too many others
  std::vector<Bond> long_out;         ///< of the file, too long to be true: left out
  std::vector<Bond> long_kept;        ///< of the file, as long, of metals or an SDF file
  std::vector<Bond> unheld;           ///< of the file, of metals to others, longer than they hold

  explicit Perception(const Structure& structure, const BondOptions& options);

  double length(std::uint32_t a, std::uint32_t b) const {
    return distance(structure.positions[a], structure.positions[b]);
  }
  void add(std::uint32_t a, std::uint32_t b, BondOrigin origin, int order) {
    bonds.push_back({std::min(a, b), std::max(a, b), origin, static_cast<std::uint8_t>(order)});
  }
  /// The atom of `piece` called `key`, or the size of the structure.
  std::uint32_t find(const ResiduePiece& piece, AtomKey key) const;
  bool exists(std::uint32_t atom) const { return atom < structure.size(); }
};

// Peptide bonds are 1.33 Angstrom long, O3'-P 1.6; two chain ends that do not belong together are
// never as close as this.
inline constexpr double longest_link = 2.0;

/// A bond of a template longer than this (Angstrom) is rejected: a periodic box has cut the
/// molecule, or the name means another atom here.
double longest_template_bond(const Structure& structure, std::uint32_t a, std::uint32_t b);

/// Sorts by (a, b) and keeps for each pair the best origin, with the best known order. Linear.
void sort_and_merge(std::vector<Bond>& bonds, std::size_t atom_count);

}  // namespace pliant::perception
