// SPDX-License-Identifier: MIT
#include "pliant/molecule/structure/cell.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "pliant/base/math/elementary.hpp"

namespace pliant {
namespace {

// No crystal has a shorter edge: that of beryllium is 2.3 Angstrom.
constexpr double shortest_edge = 2.0;

// Share of the volume of a box with the same edges: what is flatter is no cell.
constexpr double flattest = 1e-3;

/// Exact for right angles, which most cells have.
double cosine(double degrees) {
  return degrees == 90.0 ? 0.0 : exact_bits_cos(degrees * std::numbers::pi / 180.0);
}

// Positions so many edges away from the origin have lost their decimals.
constexpr double farthest_shift = 1e9;

std::int32_t nearest_whole(double value) {
  return static_cast<std::int32_t>(std::lround(std::clamp(value, -farthest_shift, farthest_shift)));
}

}  // namespace

std::optional<Cell> cell_of(const std::array<Vec3, 3>& edges) {
  double box = 1.0;
  for (Vec3 edge : edges) {
    const double length = norm(edge);
    if (!(length >= shortest_edge && std::isfinite(length))) return std::nullopt;
    box *= length;
  }
  const double volume = std::abs(dot(edges[0], cross(edges[1], edges[2])));
  if (!(volume > flattest * box)) return std::nullopt;
  return Cell{edges};
}

std::optional<Cell> cell_of(const std::array<double, 3>& lengths,
                            const std::array<double, 3>& degrees) {
  for (double angle : degrees)
    if (!(angle > 0.0 && angle < 180.0)) return std::nullopt;
  const double alpha = cosine(degrees[0]), beta = cosine(degrees[1]), gamma = cosine(degrees[2]);
  const double sine = std::sqrt(1.0 - gamma * gamma);
  const double y = (alpha - beta * gamma) / sine;
  const double z_squared = 1.0 - beta * beta - y * y;
  if (!(z_squared > 0.0)) return std::nullopt;
  const auto& [a, b, c] = lengths;
  return cell_of(std::array<Vec3, 3>{
      {{a, 0.0, 0.0}, {b * gamma, b * sine, 0.0}, {c * beta, c * y, c * std::sqrt(z_squared)}}});
}

CellImages::CellImages(const Cell& cell) : cell_(cell) {
  const auto& [a, b, c] = cell.edges;
  const double volume = dot(a, cross(b, c));
  normals_ = {(1.0 / volume) * cross(b, c), (1.0 / volume) * cross(c, a),
              (1.0 / volume) * cross(a, b)};
}

Vec3 CellImages::fractions(Vec3 position) const {
  return {dot(normals_[0], position), dot(normals_[1], position), dot(normals_[2], position)};
}

CellShift CellImages::to_nearest(Vec3 difference) const {
  const Vec3 part = fractions(difference);
  return {-nearest_whole(part.x), -nearest_whole(part.y), -nearest_whole(part.z)};
}

std::array<double, 3> CellImages::widths() const {
  return {1.0 / norm(normals_[0]), 1.0 / norm(normals_[1]), 1.0 / norm(normals_[2])};
}

}  // namespace pliant
