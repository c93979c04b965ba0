// SPDX-License-Identifier: MIT
// Secondary structure: helices and strands of a protein by the hydrogen bonds of its backbone
// (Kabsch & Sander, Biopolymers 22, 2577, 1983; DSSP), in the three classes of PyDSSP.
#pragma once

#include <span>
#include <string>

#include "pliant/base/vec3.hpp"
#include "pliant/framework/atom_table.hpp"

namespace pliant {

/// One letter a residue: 'H' helix (3-10, alpha, pi), 'E' strand or bridge, '-' neither, ' ' a
/// residue without N, CA, C and O of a backbone.
///
/// C=O..H-N is a bond below -0.5 kcal/mol of 0.084 * 332 (1/ON + 1/CH - 1/OH - 1/CN), lengths in
/// Angstrom, where O..N is 5 or less. Hydrogens are put 1.01 Angstrom from N, opposite to its two
/// heavy neighbours; those of the file are not used, and proline has none. As in PyDSSP (and so in
/// MDAnalysis, whose letters these are), residues count as neighbours in the order of the table,
/// also across the end of a chain. O(R).
std::string secondary_structure(const AtomTable& atoms, std::span<const Vec3> positions);

}  // namespace pliant
