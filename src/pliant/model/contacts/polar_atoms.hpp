// SPDX-License-Identifier: MIT
// Donors and acceptors: which atoms give and take hydrogen bonds, their hybridisation and charge.
#pragma once

#include <cstdint>
#include <vector>

#include "pliant/model/atoms/atom_graph.hpp"
#include "pliant/model/contacts/bare_donors.hpp"
#include "pliant/model/contacts/hydrogen_bond_energy.hpp"
#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

/// Polar atoms of a structure and their geometry. The structure and its graph must outlive it.
class PolarAtoms {
 public:
  PolarAtoms(const Structure& structure, const AtomGraph& graph);

  /// Hydrogens on N and O, ascending.
  const std::vector<std::uint32_t>& hydrogens() const { return hydrogens_; }
  /// O, and N with two neighbours or fewer that is not an amide's or amine's without hydrogens.
  const std::vector<std::uint32_t>& acceptors() const { return acceptors_; }
  const BareDonors& bare_donors() const { return bare_; }

  /// O: sp3 with two neighbours (but phenols and acids), at P or S, and as a bare donor; N: sp3
  /// with four neighbours, or three that are not in a plane with it.
  Hybridisation hybridisation(std::uint32_t atom) const;
  bool is_positive(std::uint32_t donor) const;
  bool is_negative(std::uint32_t acceptor) const;
  /// A normal of the plane at an atom: of its first two neighbours, or of its neighbour's; heavy
  /// atoms come before hydrogens.
  Vec3 plane(std::uint32_t atom) const;

 private:
  std::vector<std::uint32_t> heavy_first(std::uint32_t atom, std::uint32_t left) const;
  bool is_acceptor(std::uint32_t atom) const;
  bool other_nitrogen_donates(std::uint32_t donor) const;
  bool is_bonded_to(std::uint32_t atom, std::uint8_t element) const;
  bool is_in(std::uint32_t atom, std::string_view residue) const;

  const Structure& structure_;
  const AtomGraph& graph_;
  std::vector<bool> has_hydrogens_;  ///< (R)
  BareDonors bare_;
  std::vector<std::uint32_t> hydrogens_, acceptors_;
};

}  // namespace pliant
