// SPDX-License-Identifier: MIT
// An incomplete side chain: the atoms that it has, and the positions of missing atoms for each
// choice of torsions.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pliant/model/atoms/atom_graph.hpp"
#include "pliant/model/prepare/side_chain_geometry.hpp"
#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

/// A placed atom.
struct PlacedAtom {
  Vec3 position;
  std::uint8_t element;
};

/// The side chain of one of the twenty amino acids.
class SideChain {
 public:
  SideChain(const Structure& structure, const ResidueAtoms& residues, std::uint32_t residue);

  std::uint32_t residue() const { return residue_; }
  std::span<const SideChainAtom> rows() const { return rows_; }
  /// usual torsions; may be empty
  std::span<const SideChainTurns> turns() const { return turns_; }
  bool is_proline() const { return !rows_.empty() && rows_.front().residue == "PRO"; }
  /// Whether the backbone is complete, and no atom is missing between others.
  bool can_be_built() const;
  std::vector<std::string> missing() const;  ///< names of the missing atoms

  /// The missing atoms with torsions `turn`, in the order of missing().
  std::vector<PlacedAtom> placed(const SideChainTurns& turn);
  /// Error in closing proline's ring as it was placed last: squared, Angstrom^2.
  double strain() const;

 private:
  std::uint32_t find(const ResidueAtoms& residues, std::size_t k) const;
  std::size_t number(std::string_view name) const;
  Vec3 place(const SideChainAtom& row, const SideChainTurns& turn) const;
  Vec3 place_cb() const;
  const SideChainAtom* sibling_there(const SideChainAtom& row) const;

  std::uint32_t residue_;
  std::span<const SideChainAtom> rows_;
  std::span<const SideChainTurns> turns_;
  std::vector<Vec3> places_;  ///< N, CA, C, CB, then rows
  std::vector<bool> is_there_;
};

}  // namespace pliant
