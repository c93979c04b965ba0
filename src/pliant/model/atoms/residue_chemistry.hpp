// SPDX-License-Identifier: MIT
// What is known of the residues of proteins and nucleic acids by name: their heavy atoms, and
// where their polar hydrogens are.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

/// The usual name behind one of a protonation form, a force field or a chain's end: "HIS" of "HSD"
/// and "NHIE", "A" of "RA5"; the name itself where none is known.
std::string_view standard_name(std::string_view residue);

/// The heavy atoms of an amino acid's side chain, set apart by blanks: "CB OG"; "" for glycine and
/// for names that are not of the twenty.
std::string_view side_chain_atoms(std::string_view standard);

/// How hydrogens sit on their parent.
enum class HydrogenShape : std::uint8_t {
  bisector,     ///< one, against the sum of two bonds
  in_plane,     ///< up to two, in the plane of the neighbour, at 120 degrees
  spinning,     ///< up to three at a third of a turn, about the bond to the neighbour
  conjugated,   ///< one, about a bond that keeps it in the plane
  tetrahedral,  ///< two, above and below the plane of two bonds
};

/// The polar hydrogens of one atom of a residue.
struct PolarSite {
  std::string_view form;  ///< residue or protonation form: "HID"
  std::string_view atom;  ///< "ND1"
  /// Their names, set apart by blanks; in a plane the one beside the lightest atom first.
  std::string_view hydrogens;
  HydrogenShape shape;
};

/// All sites of side chains and nucleotides.
std::span<const PolarSite> polar_sites();

/// Whether a residue is water, an amino acid (by its name or its backbone), a nucleotide.
bool is_water(const Residue& residue);
bool is_amino_acid(const Residue& residue);
bool is_nucleotide(const Residue& residue);
/// A cap of a peptide: ACE, NME, NH2.
bool is_cap(const Residue& residue);

}  // namespace pliant
