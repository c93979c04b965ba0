// SPDX-License-Identifier: MIT
#include "pliant/conformers/choice/shape_distances.hpp"

#include <algorithm>
#include <cmath>

namespace pliant {
namespace {

constexpr int newton_steps = 50;

/// Sums of products of coordinates: row of one point, column of the other.
struct Covariance {
  double xx = 0, xy = 0, xz = 0, yx = 0, yy = 0, yz = 0, zx = 0, zy = 0, zz = 0;

  void add(Vec3 a, Vec3 b) {
    xx += a.x * b.x, xy += a.x * b.y, xz += a.x * b.z;
    yx += a.y * b.x, yy += a.y * b.y, yz += a.y * b.z;
    zx += a.z * b.x, zy += a.z * b.y, zz += a.z * b.z;
  }
  double square() const {
    return xx * xx + xy * xy + xz * xz + yx * yx + yy * yy + yz * yz + zx * zx + zy * zy + zz * zz;
  }
  double determinant() const {
    return xx * (yy * zz - yz * zy) - xy * (yx * zz - yz * zx) + xz * (yx * zy - yy * zx);
  }
  /// Squared sum of the 2 x 2 minors.
  double minors() const {
    const double a = yy * zz - yz * zy, b = yx * zz - yz * zx, c = yx * zy - yy * zx;
    const double d = xy * zz - xz * zy, e = xx * zz - xz * zx, f = xx * zy - xy * zx;
    const double g = xy * yz - xz * yy, h = xx * yz - xz * yx, i = xx * yy - xy * yx;
    return a * a + b * b + c * c + d * d + e * e + f * f + g * g + h * h + i * i;
  }
};

/// The sum of the singular values, the least one with the sign of the determinant: the largest root
/// of l^4 - 2 S l^2 - 8 D l + S^2 - 4 M, from above (D. L. Theobald, Acta Cryst. A 61 (2005) 478).
double best_overlap(const Covariance& c, double above) {
  const double s = c.square(), d = c.determinant(), m = c.minors();
  double l = above;
  for (int k = 0; k < newton_steps; ++k) {
    const double square = l * l;
    const double value = (square - 2.0 * s) * square - 8.0 * d * l + s * s - 4.0 * m;
    const double slope = 4.0 * (square - s) * l - 8.0 * d;
    if (!(slope > 0.0)) break;
    const double next = l - value / slope;
    if (!(next < l)) break;
    l = next;
  }
  return l;
}

}  // namespace

void ShapeDistances::add(std::span<const Vec3> x) {
  Vec3 centre{};
  for (Joint atom : symmetries_.heavy) centre += x[atom];
  centre *= 1.0 / double(std::max<std::size_t>(symmetries_.heavy.size(), 1));
  double sum = 0.0;
  for (Joint atom : symmetries_.heavy) {
    heavy_.push_back(x[atom] - centre);
    const double square = norm_squared(heavy_.back());
    radii_.push_back(std::sqrt(square));
    sum += square;
  }
  squares_.push_back(sum);
}

std::span<const Vec3> ShapeDistances::heavy(std::size_t conformer) const {
  const std::size_t n = symmetries_.heavy.size();
  return std::span(heavy_).subspan(conformer * n, n);
}

double ShapeDistances::mean_square(std::size_t one, std::size_t other,
                                   const std::vector<std::uint32_t>& map) const {
  const auto a = heavy(one), b = heavy(other);
  Covariance sum;
  for (std::size_t k = 0; k < a.size(); ++k) sum.add(a[k], b[map[k]]);
  const double both = 0.5 * (squares_[one] + squares_[other]);
  return std::max(0.0, 2.0 * (both - best_overlap(sum, both)) / double(a.size()));
}

/// No turn changes distances from the centre, so that no atom comes nearer than these differ.
bool ShapeDistances::may_be_within(std::size_t one, std::size_t other,
                                   const std::vector<std::uint32_t>& map,
                                   double mean_square) const {
  const std::size_t n = symmetries_.heavy.size();
  const auto a = std::span(radii_).subspan(one * n, n), b = std::span(radii_).subspan(other * n, n);
  double sum = 0.0;
  for (std::size_t k = 0; k < n; ++k) sum += (a[k] - b[map[k]]) * (a[k] - b[map[k]]);
  return sum <= mean_square * double(n);
}

double ShapeDistances::between(std::size_t one, std::size_t other, double reach) const {
  double least = reach * reach;
  bool is_found = false;
  for (const auto& map : symmetries_.maps) {
    if (!may_be_within(one, other, map, least)) continue;
    const double here = mean_square(one, other, map);
    if (here > least) continue;
    least = here;
    is_found = true;
  }
  return is_found ? std::sqrt(least) : HUGE_VAL;
}

}  // namespace pliant
