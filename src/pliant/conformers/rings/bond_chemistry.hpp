// SPDX-License-Identifier: MIT
// Chemistry derived from the bars of a molecule: bonds by length and elements, then rings and
// tetrahedral atoms.
#pragma once

#include <cstdint>
#include <vector>

#include "pliant/base/graphs/graph.hpp"
#include "pliant/framework/framework.hpp"

namespace pliant {

/// The atoms, in order, of a ring that shares no bond with another.
using SimpleRing = std::vector<Joint>;

/// The chemistry of a framework whose joints are atoms; without atoms there are no bonds.
class BondChemistry {
 public:
  /// `start` (N, Angstrom). The framework must outlive it.
  BondChemistry(const Framework& framework, std::span<const Vec3> start);

  std::size_t atoms() const { return is_in_ring_.size(); }
  std::span<const Link> bonds_at(Joint atom) const { return bonds_.at(atom); }
  /// Atomic number; 0 without atoms.
  std::uint8_t element(Joint atom) const;
  bool is_hydrogen(Joint atom) const { return element(atom) == 1; }
  bool is_oxygen(Joint atom) const { return element(atom) == 8; }
  bool is_nitrogen(Joint atom) const { return element(atom) == 7; }
  /// Donors of hydrogen bonds are hydrogen of N or O and its parent, acceptors O and N.
  bool donates(Joint atom) const;
  bool accepts(Joint atom) const { return is_oxygen(atom) || is_nitrogen(atom); }
  /// Whether nitrogen forms a tertiary amide with one of its neighbours.
  bool is_acylated(Joint nitrogen) const;
  /// Whether it is carbon with three bonds in a plane, one of them to terminal O or S.
  bool is_acyl(Joint atom) const;
  /// Number of bonds to atoms other than hydrogen.
  int heavy_bonds_at(Joint atom) const;
  /// Whether its bonds are arranged as in sp3 carbon; false if they lie in a plane.
  bool is_tetrahedral(Joint atom) const;
  /// Whether the bond from `from` has only hydrogens beyond `atom`: CH3, NH3 and the like.
  bool spins_alike(Joint from, Joint atom) const;
  /// Whether its bonds lie in a plane, or it is nitrogen or oxygen of an amide or ester, which
  /// files may show less flat than it is.
  bool is_conjugated(Joint atom) const;
  /// The neighbour of `atom`, other than `except`, that torsions refer to; `atom` itself if there
  /// is none. Rather one of the same ring than another (N without hydrogen first), then C=O and S,
  /// then what has other neighbours, and hydrogen last.
  Joint reference(Joint atom, Joint except) const;
  /// Rings of five atoms or more, in the order of their lowest atoms.
  std::vector<SimpleRing> simple_rings() const;
  /// The bonds of each set of rings that share bonds.
  std::vector<std::vector<Bar>> ring_blocks() const;
  bool is_bonded(Joint a, Joint b) const;
  /// Atoms that can be reached from `atom` without passing `walls`, without `atom` itself.
  std::vector<Joint> beyond(Joint atom, const std::vector<Joint>& walls) const;
  bool is_in_ring(Joint atom) const { return is_in_ring_[atom]; }
  /// Whether it is a ring atom with three bonds in a plane, and planar neighbours in the ring:
  /// benzene, pyridine, naphthalene.
  bool is_aryl(Joint atom) const;
  /// Whether both neighbours in its ring have substituents other than hydrogen.
  bool is_flanked(Joint aryl) const;
  /// Whether the bond from carbon `c` to nitrogen `n` is that of a tertiary amide: the carbon has
  /// terminal O or S, the nitrogen no hydrogen, both are planar, and the bond is in no ring.
  bool is_tertiary_amide(Joint c, Joint n) const;
  /// The same, or of a secondary one, whose nitrogen bears one hydrogen and may be a pyramid.
  bool is_amide(Joint c, Joint n) const;
  /// Whether the bond from carbon `c` to nitrogen `n` is the single one of an amidine, N=C-N-R, and
  /// in no ring.
  bool is_amidine(Joint c, Joint n) const;
  /// Whether the bond is in a ring of at most `most` atoms.
  bool is_in_ring_up_to(std::size_t most, Joint a, Joint b) const;
  /// Whether the bond from carbon `c` to nitrogen `n` is that of an amide in a ring of nine atoms
  /// and more, and in no smaller one; strained ones may be less flat. `is_tertiary`: nitrogen has
  /// no hydrogen.
  bool is_ring_amide(Joint c, Joint n, bool is_tertiary) const;
  /// Whether the bond from carbon `c` to oxygen `o` is that of an ester: O=C-O-R.
  bool is_ester(Joint c, Joint o) const;
  /// Whether it is nitrogen with three bonds that do not lie in a plane, which inverts (an amine).
  /// Not in rings of three, where it may keep its handedness, nor in amides.
  bool is_amine(Joint atom) const;

 private:
  int rank_of(const Link& bond) const;
  bool bears_apart(Joint n, Joint c) const;
  bool is_in_ring_of_three(Joint atom) const;
  bool is_beside_acyl(Joint atom) const;
  static SimpleRing in_order(const std::vector<Bar>& edges);

  const Framework& framework_;
  std::span<const Vec3> start_;
  std::vector<Bar> edges_;
  Graph bonds_;
  std::vector<bool> is_in_ring_;
  std::vector<bool> is_ring_bond_;  ///< (bonds)
};

}  // namespace pliant
