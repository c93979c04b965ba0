// SPDX-License-Identifier: MIT
// Donors of molecules whose hydrogens the file lacks, as those of most ligands: where the hydrogen
// of a bond would be.
#pragma once

#include <cstdint>
#include <vector>

#include "pliant/model/atoms/atom_graph.hpp"
#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

/// N and O of residues without any hydrogen, neither of proteins nor of nucleic acids, that may
/// have some by their neighbours and bond lengths. A guess: bond orders are not known. The
/// structure and its graph must outlive it.
class BareDonors {
 public:
  /// `has_hydrogens` (R): residues that have some.
  BareDonors(const Structure& structure, const AtomGraph& graph,
             const std::vector<bool>& has_hydrogens);

  /// Ascending.
  const std::vector<std::uint32_t>& atoms() const { return atoms_; }
  bool contains(std::uint32_t atom) const { return is_donor_[atom]; }
  /// How many bonds it may give: NH and OH one, NH2 two.
  std::size_t hydrogens_of(std::uint32_t donor) const;
  /// Where its hydrogen would be for a bond to `acceptor`, Angstrom: 1.0 away, at the angle of its
  /// other bonds, as near to it as that lets.
  Vec3 hydrogen_towards(std::uint32_t donor, Vec3 acceptor) const;

 private:
  bool may_donate(std::uint32_t atom) const;
  bool has_other_neighbours(std::uint32_t atom) const;

  const Structure& structure_;
  const AtomGraph& graph_;
  std::vector<bool> is_donor_;  ///< (N)
  std::vector<std::uint32_t> atoms_;
};

/// Whether N is one of an amide: bonded to a C with a terminal O, nearer than a single bond is.
bool is_amide_nitrogen(const Structure& structure, const AtomGraph& graph, std::uint32_t atom);

}  // namespace pliant
