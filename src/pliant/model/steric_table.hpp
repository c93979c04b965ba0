// SPDX-License-Identifier: MIT
// Least distances of atoms of molecules for pairs four or more bonds apart. Carbon includes CH, CH2
// and CH3: 3.2 Angstrom, above the 2.9 to 3.0 for bare carbon of Ramachandran and Sasisekharan
// (Adv. Protein Chem. 23 (1968) 283), whose outer limits the other values are. No two of C, N, O
// and S come within 0.02 Angstrom of a MolProbity clash (an overlap of 0.4), except pairs of N and
// O of which one has a hydrogen, which hydrogen bonds bring together.
#pragma once

#include <string_view>
#include <vector>

#include "pliant/framework/sterics.hpp"
#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

/// Names of the kinds of atom in the order of their numbers: C N NH O OH S H HC M X. NH and OH have
/// hydrogens, or may have some that the file lacks; H is polar, HC on carbon, M a metal, X any
/// other; F counts as O; P, Se and other halogens count as S.
std::vector<std::string_view> steric_kind_names();

/// The sterics of a structure whose bonds are known: kinds, table, and bonds for exclusion (up to
/// three apart). Own distances are empty; own_distances() finds them. With `clashes_count`,
/// hydrogens on carbon keep 0.02 Angstrom more than the distance of a MolProbity clash; otherwise
/// some come nearer, since many models leave these hydrogens out.
Sterics molecular_sterics(const Structure& structure, bool clashes_count = false);

}  // namespace pliant
