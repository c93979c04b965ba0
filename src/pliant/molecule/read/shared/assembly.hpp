// SPDX-License-Identifier: MIT
// Biological assemblies (biological units): copies of chains, each turned and shifted as the file
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

/// First `second`, then `first`: the product of their matrices in this order.
RigidMotion product(const RigidMotion& first, const RigidMotion& second);

/// Chains, and what each of them is copied by.
struct AssemblyPart {
  std::vector<std::string> chains;  ///< as AtomSites::instances names them
  std::vector<RigidMotion> motions;
};

/// Copies of all its parts together.
using Assembly = std::vector<AssemblyPart>;

/// More motions than any file has; a few bytes could ask for billions.
inline constexpr std::size_t most_motions = 10000;

/// Throws OptionError naming those that the file states unless `wanted` is one of them.
void check_assembly(const std::vector<std::string>& stated, const std::string& wanted,
                    const Remarks& remarks);

/// Puts the copies in place of the atoms of `sites.structure`: by motion, in the order of the file.
/// The first copy of a chain keeps its name, others take the first character that is free (A to Z,
/// a to z, 0 to 9), then two. Atoms that a motion takes to within 0.5 Angstrom of their own copy,
/// as on an axis of symmetry, are there once. Serial numbers are 1 to N anew where there are
/// several copies. Notes which chains there are; warns of atoms on axes. Throws InputError where no
/// chain of it is there, or it would have more than 20 million atoms.
void make_assembly(AtomSites& sites, const std::string& name, const Assembly& assembly,
                   Remarks& remarks);

}  // namespace pliant
