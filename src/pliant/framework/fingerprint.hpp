// SPDX-License-Identifier: MIT
// Fingerprints: whether two machines, or a file and a command, mean the same atoms in the same
// places.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "pliant/base/vec3.hpp"
#include "pliant/framework/atom_table.hpp"

namespace pliant {

/// Of all bits of these positions: FNV-1a of 64 bits (Fowler, Noll, Vo), bytes from the lowest one
/// on, the same on every machine. No protection against those who mean to deceive.
std::uint64_t fingerprint(std::span<const Vec3> positions);

/// Of the same, and of names, elements and residue names: of a structure as it was read. Chains,
/// numbers and bonds do not count.
std::uint64_t fingerprint(const AtomTable& atoms, std::span<const Vec3> positions);

/// 16 hexadecimal digits.
std::string fingerprint_text(std::uint64_t fingerprint);

}  // namespace pliant
