// SPDX-License-Identifier: MIT
// Torsion preferences: usual ranges of torsions about bonds. A resolve pulls towards them, but they
// never decide whether a frame is whole.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "pliant/base/vec3.hpp"

namespace pliant {

/// The torsion of joints 0-1-2-3 about a bond of two tetrahedral atoms: usual within `free` of 60,
/// 180 and 300 degrees.
struct StaggeredTorsion {
  std::array<std::uint32_t, 4> joints{};
  double free = 0.0;  ///< radians, up to pi / 3, which is the whole circle
};

/// phi (joints 0-1-2-3) and psi (1-2-3-4) of a residue: usual where backbone_reach() is at most
/// `reach`.
struct BackboneTorsions {
  std::array<std::uint32_t, 5> joints{};
  double reach = 1.0;
};

struct TorsionPreferences {
  std::vector<StaggeredTorsion> staggered = {};
  std::vector<BackboneTorsions> backbone = {};
};

/// The same data as columns, for files.
struct TorsionColumns {
  std::vector<std::uint32_t> staggered = {};  ///< (S * 4) joints
  std::vector<double> free = {};              ///< (S) radians
  std::vector<std::uint32_t> backbone = {};   ///< (B * 5) joints
  std::vector<double> reach = {};             ///< (B)
};
TorsionColumns columns_of(const TorsionPreferences& preferences);
/// Throws InputError where columns differ in length.
TorsionPreferences torsion_preferences_of(const TorsionColumns& columns);

/// Throws InputError naming what is wrong: a joint that does not exist or comes twice, `free` out
/// of range, a reach that is not finite and above 0.
void check(const TorsionPreferences& preferences, std::size_t joint_count);

/// The torsion a-b-c-d from -pi to pi (radians); 0 if three points lie on a line. The same bits on
/// every machine.
double torsion_angle(Vec3 a, Vec3 b, Vec3 c, Vec3 d);

/// Difference of a torsion from the nearest of 60, 180 and 300 degrees (radians, signed).
double off_staggered(double torsion);

/// How far phi and psi are outside the regions of the Ramachandran plot where residues other than
/// glycine and proline lie (the 99 % contours of Lovell et al., Proteins 50 (2003) 437, drawn as
/// ellipses): 1 at the edge of the nearest region, below 1 inside.
double backbone_reach(double phi, double psi);

/// The turns of phi and psi (radians) that lead to the edge of the nearest region of that reach; 0
/// inside a region.
struct BackboneTurn {
  double phi = 0.0, psi = 0.0;
};
BackboneTurn backbone_turn(double phi, double psi, double reach);

}  // namespace pliant
