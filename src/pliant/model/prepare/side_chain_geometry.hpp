// SPDX-License-Identifier: MIT
// Geometry of side chains: lengths and angles of R. A. Engh, R. Huber, Acta Cryst. A 47 (1991) 392,
// and the usual torsions (S. C. Lovell et al., Proteins 40 (2000) 389), in tens of degrees, the
// commonest first.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "pliant/base/vec3.hpp"

namespace pliant {

/// Position of an atom: `length` Angstrom from `parent`, at an `angle` (degrees) to `neighbour`,
/// with a torsion about that bond from `reference`: the `chi`-th free torsion, or, if `chi` is 0,
/// `turn` tens of degrees.
struct SideChainAtom {
  std::string_view residue, name, reference, neighbour, parent;
  std::uint8_t element;
  double length, angle;
  std::uint8_t chi;
  std::int8_t turn;
};

/// Rows of an amino acid, each after the atoms that it refers to; CB has none.
std::span<const SideChainAtom> side_chain_geometry(std::string_view standard);

/// Position of CB from N, CA and C of an ideal residue.
Vec3 ideal_cb(Vec3 n, Vec3 ca, Vec3 c);

/// Two atoms of a residue whose bond closes a ring of its side chain.
struct RingBond {
  std::string_view residue, one, other;
};
std::span<const RingBond> ring_bonds();

/// chi 1 to 4 in tens of degrees.
using SideChainTurns = std::array<std::int8_t, 4>;

/// The usual torsions of a residue.
std::span<const SideChainTurns> usual_turns(std::string_view standard);

}  // namespace pliant
