// SPDX-License-Identifier: MIT
// Kinds of bonds that turn, and their usual torsions with energies: after distributions in crystals
// of small molecules (C. Schaerfer et al., J. Med. Chem. 56 (2013) 2016; W. Guba et al., J. Chem.
// Inf. Model. 56 (2016) 1; P. C. D. Hawkins et al., J. Chem. Inf. Model. 50 (2010) 572) and the
// heights of torsional potentials (S. Riniker, G. A. Landrum, J. Chem. Inf. Model. 55 (2015) 2562).
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace pliant {

/// Kinds of bonds that turn. Alkyl is sp3 carbon; "branched" has three heavy neighbours or more.
/// Aryl groups are flat rings. "ortho" has one heavy atom beside the bond, "flanked" two.
enum class BondTurn : std::uint8_t {
  any,                  ///< unknown: multiples of 30 degrees
  staggered,            ///< between sp3 atoms, one of them branched
  alkyl,                ///< CH2 - CH2
  gauche,               ///< the same between O, N or F
  ether,                ///< O - CH2
  ether_branched,       ///< O - CHR2
  amine,                ///< NHR - CH2
  thioether,            ///< S - CH2
  disulfide,            ///< S - S
  phosphate,            ///< P - O
  ester,                ///< O=C-O-R: as in the structure (Z, unless the file has E)
  acid,                 ///< O=C-O-H
  ester_alkyl,          ///< O of an ester - CH2
  ester_branched,       ///< O of an ester - CHR2
  amide_alkyl,          ///< N of an amide that bears hydrogen - CH2
  amide_branched,       ///< the same - CHR2
  acyl_alkyl,           ///< C=O - CH2
  acyl_branched,        ///< C=O - CHR2
  acyl_hetero,          ///< C=O - CH2 of an ether or amine
  acyl_benzyl,          ///< C=O - CH2 of a flat group
  sulfonamide,          ///< SO2 - N
  sulfonamide_alkyl,    ///< N of a sulfonamide - alkyl
  aryl_sulfonyl,        ///< aryl - SO2
  aryl_sulfide,         ///< aryl - S
  aryl_ether,           ///< aryl - O - CH3, CH2
  aryl_ether_branched,  ///< aryl - O - CHR2, CR3
  diaryl,               ///< aryl - O, S or CH2 - aryl
  aryl_ester,           ///< aryl - O of an ester
  flanked,              ///< aryl - O, flanked
  aryl_amine,           ///< aryl - N
  aryl_amine_ortho,     ///< the same with one heavy atom beside it
  off_plane,            ///< aryl - N, flanked
  aryl_amide,           ///< aryl - N of an amide that bears hydrogen
  aryl_amide_ortho,     ///< the same with heavy atoms beside it
  aryl_acylated,        ///< aryl - N of a tertiary amide
  aryl_sulfonamide,     ///< aryl - N of a sulfonamide
  aryl_acyl,            ///< aryl - C=O of an amide
  aryl_acyl_ortho,      ///< the same with one heavy atom beside it
  aryl_acyl_flanked,    ///< the same with two
  aryl_ketone,          ///< aryl - C=O of an acid, ester or ketone
  pyridyl_amide,        ///< N of the ring beside the bond, NH or C=O of an amide: NH at that N
  flat_primary,         ///< aryl, or planar N without hydrogen, - CH2
  flat_hetero,          ///< aryl - CH2 of an ether or amine
  flat_branched,        ///< the same - CHR2
  flat_quaternary,      ///< the same - CR3
  biaryl,               ///< aryl - aryl
  biaryl_plane,         ///< the same with an atom without hydrogen beside the bond
  biaryl_ortho,         ///< aryl - aryl with one heavy atom beside the bond
  biaryl_flanked,       ///< the same with two
  atropisomer,  ///< the same with three or four: as in the structure, since it cannot pass 0
  in_plane,     ///< aryl - nitro, aryl - OH
  conjugated,   ///< between double bonds
  aryl_vinyl,   ///< aryl - C=C, aryl - C=N
  allyl,        ///< C=C - alkyl
  hydrazine,    ///< N - N
  beside_acyl,  ///< in large rings: O or N of ester or amide - sp3
  ring_amide,   ///< in rings of nine and more: amides that turn
};

/// Whether torsions of this kind stay near that of the structure.
constexpr bool stays(BondTurn kind) {
  return kind == BondTurn::ester || kind == BondTurn::atropisomer;
}

/// A usual torsion; its mirror image is one as well.
struct TorsionPeak {
  double angle;   ///< degrees, 0 to 180
  double energy;  ///< kcal/mol above the lowest
  double width;   ///< degrees, standard deviation
};

/// One row of the table of kinds.
struct BondTurnEntry {
  BondTurn kind;
  std::string_view name;
  std::span<const TorsionPeak> peaks;
};

std::span<const BondTurnEntry> bond_turns();
const BondTurnEntry& entry(BondTurn kind);

}  // namespace pliant
