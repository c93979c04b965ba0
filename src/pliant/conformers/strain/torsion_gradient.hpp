// SPDX-License-Identifier: MIT
// A torsion and its gradient (A. Blondel, M. Karplus, J. Comput. Chem. 17 (1996) 1132).
#pragma once

#include <array>
#include <optional>

#include "pliant/base/vec3.hpp"

namespace pliant {

/// Half of the threefold barrier of a bond between sp3 carbon atoms in UFF (A. K. Rappe et al., J.
/// Am. Chem. Soc. 114 (1992) 10024), kcal/mol.
inline constexpr double half_threefold_barrier = 1.06;

struct TorsionGradient {
  double cosine, sine;
  std::array<Vec3, 4> gradient;  ///< radians/Angstrom, with respect to the four points
};

/// The torsion i-a-b-j; nothing where three of the points lie on a line.
std::optional<TorsionGradient> torsion_gradient(Vec3 i, Vec3 a, Vec3 b, Vec3 j);

}  // namespace pliant
