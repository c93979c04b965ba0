// SPDX-License-Identifier: MIT
#include "pliant/conformers/strain/torsion_gradient.hpp"

#include <cmath>

namespace pliant {

std::optional<TorsionGradient> torsion_gradient(Vec3 i, Vec3 a, Vec3 b, Vec3 j) {
  const Vec3 f = i - a, g = a - b, h = j - b;
  const Vec3 one = cross(f, g), other = cross(h, g);
  const double one_square = norm_squared(one), other_square = norm_squared(other);
  const double length = norm(g);
  if (!(one_square > 1e-8 && other_square > 1e-8 && length > 1e-4)) return std::nullopt;
  const double both = std::sqrt(one_square * other_square);
  TorsionGradient found{dot(one, other) / both, dot(cross(other, one), g) / (both * length), {}};
  const Vec3 from = (1.0 / one_square) * one, to = (1.0 / other_square) * other;
  const Vec3 along = (dot(f, g) / length) * from - (dot(h, g) / length) * to;
  found.gradient = {-length * from, length * from + along, -along - length * to, length * to};
  return found;
}

}  // namespace pliant
