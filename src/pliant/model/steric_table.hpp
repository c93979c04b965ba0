// SPDX-License-Identifier: MIT
// Least distances of atoms of molecules, pairs four or more bonds apart. Carbon stands for CH, CH2
// and CH3 too: 3.2 Angstrom, above the 2.9 to 3.0 of Ramachandran and Sasisekharan (Adv. Protein
// Chem. 23 (1968) 283) for bare carbon, from whom the others are (outer limits). No two of C, N, O
// and S come within 0.02 Angstrom of a clash of MolProbity's, an overlap of 0.4, but two of N and O
// one of which has a hydrogen: hydrogen bonds bring them together.
#pragma once

#include <string_view>
#include <vector>

#include "pliant/framework/sterics.hpp"
#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

/// Names of the kinds of atom in the order of their numbers: C N NH O OH S H HC M X. NH and OH
/// have hydrogens, or belong to what was left without any; H is polar, HC on carbon, M a metal, X
/// any other; F counts as O; P, Se and other halogens count as S.
std::vector<std::string_view> steric_kind_names();

/// The sterics of a structure whose bonds are known: its kinds, the table, its bonds for what is
/// excluded (up to three apart). Own distances are empty: own_distances() finds them.
/// `clashes_count`: hydrogens on carbon keep 0.02 Angstrom more than the distance at which
/// MolProbity counts a serious clash; usually some are let nearer, since many models leave them
/// out.
Sterics molecular_sterics(const Structure& structure, bool clashes_count = false);

}  // namespace pliant
