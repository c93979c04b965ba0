// SPDX-License-Identifier: MIT
// Biological assemblies (biological units): copies of chains, rotated and shifted as the file
// states.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "pliant/molecule/read/shared/atom_sites.hpp"

namespace pliant {

/// x -> turn x + shift.
struct RigidMotion {
  std::array<double, 9> turn{1, 0, 0, 0, 1, 0, 0, 0, 1};  ///< row by row
  Vec3 shift;                                             ///< Angstrom

  Vec3 operator()(Vec3 x) const;
  friend bool operator==(const RigidMotion&, const RigidMotion&) = default;
};

/// The motion that applies `second`, then `first`: the product of their matrices in this order.
RigidMotion product(const RigidMotion& first, const RigidMotion& second);

/// Chains, and the motions that make their copies.
struct AssemblyPart {
  std::vector<std::string> chains;  ///< as AtomSites::instances names them
  std::vector<RigidMotion> motions;
};

/// An assembly: the copies of all its parts.
using Assembly = std::vector<AssemblyPart>;

/// Largest number of motions, more than any file has: a few bytes could ask for billions.
inline constexpr std::size_t most_motions = 10000;

/// Throws OptionError, listing the assemblies of the file, unless `wanted` is one of them.
void check_assembly(const std::vector<std::string>& stated, const std::string& wanted,
                    const Remarks& remarks);

/// Replaces the atoms of `sites.structure` by the copies, motion by motion, in the order of the
/// file. The first copy of a chain keeps its name, others get the first free character (A to Z, a
/// to z, 0 to 9), then two characters. Atoms that a motion moves to within 0.5 Angstrom of their
/// own copy, as on a symmetry axis, occur once. Serials are renumbered from 1 where there are
/// several copies. Notes the chains; warns of atoms on axes. Throws InputError if no chain of the
/// assembly is there, or if it would have more than 20 million atoms.
void make_assembly(AtomSites& sites, const std::string& name, const Assembly& assembly,
                   Remarks& remarks);

}  // namespace pliant
