// SPDX-License-Identifier: MIT
// What the bars of a molecule say of its chemistry: which are bonds, by length and elements, and
// with that where rings are and which atoms are tetrahedral.
#pragma once

#include <cstdint>
#include <vector>

#include "pliant/base/graphs/graph.hpp"
#include "pliant/framework/framework.hpp"

namespace pliant {

/// A ring that shares no bond with another, in its order.
using SimpleRing = std::vector<Joint>;

/// Of a framework whose joints are atoms; of another, nothing is known.
class BondChemistry {
 public:
  /// `start` (N, Angstrom). The framework must outlive it.
  BondChemistry(const Framework& framework, std::span<const Vec3> start);

  std::span<const Link> bonds_at(Joint atom) const { return bonds_.at(atom); }
  bool is_hydrogen(Joint atom) const { return element(atom) == 1; }
  bool is_oxygen(Joint atom) const { return element(atom) == 8; }
  bool is_nitrogen(Joint atom) const { return element(atom) == 7; }
  /// Of a hydrogen bond: hydrogen of N or O, or what bears it; and O or N.
  bool donates(Joint atom) const;
  bool accepts(Joint atom) const { return is_oxygen(atom) || is_nitrogen(atom); }
  /// Nitrogen that makes a tertiary amide with one of its neighbours.
  bool is_acylated(Joint nitrogen) const;
  /// Carbon with three bonds in a plane, at which oxygen or sulphur ends.
  bool is_acyl(Joint atom) const;
  /// Bonds to other atoms than hydrogen.
  int heavy_bonds_at(Joint atom) const;
  /// Whether its bonds lie about it as about sp3 carbon; false where they lie in a plane.
  bool is_tetrahedral(Joint atom) const;
  /// CH3, NH3 and their like: nothing but hydrogens beyond the bond from `from`.
  bool spins_alike(Joint from, Joint atom) const;
  /// Its bonds lie in a plane, or it is nitrogen or oxygen of an amide or ester, which may be drawn
  /// less flat than it is.
  bool is_conjugated(Joint atom) const;
  /// The atom bonded to `atom`, but `except`, that torsions are counted from: no hydrogen if that
  /// can be; `atom` itself if there is none.
  Joint reference(Joint atom, Joint except) const;
  /// Rings of five atoms or more, by their lowest atom.
  std::vector<SimpleRing> simple_rings() const;
  /// Bonds of each set of rings that share bonds.
  std::vector<std::vector<Bar>> ring_blocks() const;
  bool is_bonded(Joint a, Joint b) const;
  /// Atoms that are reached from `atom` without passing `walls`, itself left out.
  std::vector<Joint> beyond(Joint atom, const std::vector<Joint>& walls) const;
  bool is_in_ring(Joint atom) const { return is_in_ring_[atom]; }
  /// An atom of a ring, three bonds in a plane, its neighbours in the ring planar as well: benzene,
  /// pyridine, naphthalene.
  bool is_aryl(Joint atom) const;
  /// Whether what stands beside it in its ring bears more than hydrogens, on both sides.
  bool is_flanked(Joint aryl) const;
  /// Whether carbon `c` and nitrogen `n` are bonded as a tertiary amide: oxygen or sulphur ends at
  /// the carbon, the nitrogen bears no hydrogen, and the bond is in no ring. In a plane each.
  bool is_tertiary_amide(Joint c, Joint n) const;
  /// Whether the bond from carbon `c` to oxygen `o` is that of an ester: O=C-O-R.
  bool is_ester(Joint c, Joint o) const;
  /// Nitrogen with three bonds that do not lie in a plane: an amine, which inverts; but in rings of
  /// three, where it may keep its handedness, and in amides.
  bool is_amine(Joint atom) const;

 private:
  std::uint8_t element(Joint atom) const;
  bool is_in_ring_of_three(Joint atom) const;
  bool is_beside_acyl(Joint atom) const;
  static SimpleRing in_order(const std::vector<Bar>& edges);

  const Framework& framework_;
  std::span<const Vec3> start_;
  std::vector<Bar> edges_;
  Graph bonds_;
  std::vector<bool> is_in_ring_;
};

}  // namespace pliant
