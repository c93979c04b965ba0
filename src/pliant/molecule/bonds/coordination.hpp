// SPDX-License-Identifier: MIT
// Coordination of metals. A metal and an atom of the same residue are bonded, as in haem, cobalamin
// and ferrocene. A metal and an atom of another residue are not: they hold each other from a
// distance, which the positions show, whatever records (LINK, struct_conn, CONECT) say.
#pragma once

#include <cstdint>

#include "pliant/framework/atom_table.hpp"
#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

/// How far (Angstrom) a metal may hold an atom of another residue: N, O and S 2.8, or 1.2 times the
/// sum of covalent radii where that is more (K - O: 3.2); Se and halogens 2.8; C 2.3; 0 for others.
double coordination_reach(std::uint8_t metal, std::uint8_t held);

/// Whether a bond joins a metal to an atom of another residue that is no metal.
bool is_coordination(const AtomTable& atoms, const Bond& bond);

}  // namespace pliant
