// SPDX-License-Identifier: MIT
// Fingerprints: they tell whether two machines, or a file and a command, have the same atoms in the
// same places.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "pliant/base/vec3.hpp"
#include "pliant/framework/atom_table.hpp"

namespace pliant {

/// A hash of all bits of the positions: FNV-1a of 64 bits (Fowler, Noll, Vo), bytes from the lowest
/// one on, the same on every machine. It does not protect against deliberate collisions.
std::uint64_t fingerprint(std::span<const Vec3> positions);

/// A hash of a structure as it was read: positions, names, elements and residue names, but neither
/// chains nor numbers nor bonds.
std::uint64_t fingerprint(const AtomTable& atoms, std::span<const Vec3> positions);

/// The fingerprint as 16 hexadecimal digits.
std::string fingerprint_text(std::uint64_t fingerprint);

}  // namespace pliant
