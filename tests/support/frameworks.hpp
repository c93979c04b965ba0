// SPDX-License-Identifier: MIT
// What tests do with frameworks: variants of one, measures of positions.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "pliant/framework/framework.hpp"
#include "pliant/resolve/resolve.hpp"

namespace pliant::test {

/// The parts that make `framework` again.
FrameworkParts parts_of(const Framework& framework);

/// `framework` with masses of 1 to 16 u.
Framework with_masses(const Framework& framework);
Framework with_pinned(const Framework& framework, std::vector<Joint> pinned);
/// `framework` with the two ends of every bar exchanged.
Framework with_swapped_ends(const Framework& framework);

/// One kind of joints: no two come nearer than `least`, but for those that few bonds join.
std::shared_ptr<Sterics> spheres(std::size_t joints, double least, int excluded_bonds = 3);

/// So many copies of a framework side by side, each `apart` from the one before: bars alone, drawn
/// so.
Framework copies_of(const Framework& framework, std::span<const Vec3> positions, std::size_t count,
                    Vec3 apart);

/// The shortest rest length; 1 if there is no bar.
double shortest_bar(const Framework& framework);
/// Each position moved by `size` in a random direction, pinned joints left.
std::vector<Vec3> shake(const Framework& framework, std::span<const Vec3> positions, double size,
                        std::uint64_t seed = 1);
/// Rotated by a proper rotation and shifted.
std::vector<Vec3> moved_rigidly(std::span<const Vec3> positions);
/// Largest |length - rest| / rest of the bars.
double worst_bar(const Framework& framework, std::span<const Vec3> positions);
/// Largest distance between two places of a joint.
double largest_difference(std::span<const Vec3> a, std::span<const Vec3> b);
/// Largest absolute coordinate, at least 1.
double extent(std::span<const Vec3> positions);
Vec3 centre_of_mass(const Framework& framework, std::span<const Vec3> positions);
bool all_finite(std::span<const Vec3> positions);
bool same_bits(std::span<const Vec3> a, std::span<const Vec3> b);

/// FNV-1a over the bytes of the coordinates, lowest byte first whatever the machine.
std::uint64_t hash_of(std::span<const Vec3> positions, std::uint64_t hash = 0xcbf29ce484222325u);

}  // namespace pliant::test
