// SPDX-License-Identifier: MIT
// Properties of the residues of proteins and nucleic acids by name: heavy atoms and sites of polar
// hydrogens.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

/// The standard name of a protonation form, a force field's residue or a chain end: "HIS" for "HSD"
/// and "NHIE", "A" for "RA5"; the name itself if no other is known.
std::string_view standard_name(std::string_view residue);

/// The heavy atoms of an amino acid's side chain, separated by blanks: "CB OG"; "" for glycine and
/// for names other than the twenty.
std::string_view side_chain_atoms(std::string_view standard);

/// Geometry of the hydrogens at an atom.
enum class HydrogenShape : std::uint8_t {
  bisector,     ///< one, opposite to the sum of two bonds
  in_plane,     ///< up to two, in the plane of the neighbour, at 120 degrees
  spinning,     ///< up to three, 120 degrees apart about the bond to the neighbour
  conjugated,   ///< one, about a bond that keeps it in a plane
  tetrahedral,  ///< up to two, above and below the plane of two bonds
  opposite,     ///< one, opposite to the sum of three bonds
};

/// The polar hydrogens of one atom of a residue.
struct PolarSite {
  std::string_view form;  ///< residue or protonation form: "HID"
  std::string_view atom;  ///< "ND1"
  /// Their names, separated by blanks; in a plane the one next to the lightest atom comes first.
  std::string_view hydrogens;
  HydrogenShape shape;
};

/// All sites of side chains and nucleotides.
std::span<const PolarSite> polar_sites();

/// Whether a residue is water, an amino acid or a nucleotide, by its name.
bool is_water(const Residue& residue);
bool is_amino_acid(const Residue& residue);
bool is_nucleotide(const Residue& residue);
/// Whether it is a cap of a peptide: ACE, NME, NH2.
bool is_cap(const Residue& residue);

/// (R) Whether each residue is a part of a polymer: bonded to another residue, but not to a metal,
/// or one of two and more that are amino acids or nucleotides by name. What atoms are called says
/// nothing: a ligand may have N and CA, or C4', too.
std::vector<bool> polymer_residues(const Structure& structure);

}  // namespace pliant
