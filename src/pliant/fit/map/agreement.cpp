// SPDX-License-Identifier: MIT
#include "pliant/fit/map/agreement.hpp"

#include "pliant/base/error.hpp"
#include "pliant/base/number.hpp"
#include "pliant/fit/map/simulated.hpp"

namespace pliant {
namespace {

double checked_radius(double radius) {
  if (!(radius > 0.0 && radius <= 100.0))
    throw OptionError("radius = " + number_text(radius) +
                      ": must be above 0, and 100 at most (Angstrom)");
  return radius;
}

}  // namespace

MapAgreement::MapAgreement(const DensityMap& map, std::span<const Vec3> positions,
                           std::span<const double> weights, double resolution, double radius)
    : map_(map),
      positions_(positions.begin(), positions.end()),
      expected_(simulated(map.grid(), positions, weights, resolution)),
      radius_(checked_radius(radius)) {}

/// Adds the points near to a position that have not been seen.
void MapAgreement::gather(Vec3 position, std::vector<std::uint8_t>& seen,
                          std::vector<std::size_t>& points) const {
  for_each_point_near(map_.grid(), map_.places(), position, radius_,
                      [&](std::size_t point, double) {
                        if (seen[point] == 0) points.push_back(point);
                        seen[point] = 1;
                      });
}

double MapAgreement::correlation_at(std::span<const std::size_t> points) const {
  if (points.size() < 2) return 0.0;
  const std::span<const float> found = map_.values(), expected = expected_.values();
  double mean_found = 0.0, mean_expected = 0.0;
  for (const std::size_t point : points) {
    mean_found += found[point];
    mean_expected += expected[point];
  }
  mean_found /= static_cast<double>(points.size());
  mean_expected /= static_cast<double>(points.size());
  double both = 0.0, squares_found = 0.0, squares_expected = 0.0;
  for (const std::size_t point : points) {
    const double a = found[point] - mean_found, b = expected[point] - mean_expected;
    both += a * b;
    squares_found += a * a;
    squares_expected += b * b;
  }
  const double scale = std::sqrt(squares_found) * std::sqrt(squares_expected);
  return scale > 0.0 ? std::clamp(both / scale, -1.0, 1.0) : 0.0;
}

double MapAgreement::overall() const {
  std::vector<std::uint8_t> seen(map_.grid().size(), 0);
  std::vector<std::size_t> points;
  for (const Vec3 position : positions_) gather(position, seen, points);
  if (points.empty())
    throw InputError("density map: no point is within " + number_text(radius_) +
                     " Angstrom of an atom: the molecule is outside of the map");
  return correlation_at(points);
}

std::vector<double> MapAgreement::by_group(std::span<const std::uint32_t> group_of,
                                           std::size_t groups) const {
  std::vector<std::vector<std::size_t>> members(groups);
  for (std::size_t atom = 0; atom < group_of.size(); ++atom)
    members[group_of[atom]].push_back(atom);
  std::vector<std::uint8_t> seen(map_.grid().size(), 0);
  std::vector<double> out;
  std::vector<std::size_t> points;
  for (const std::vector<std::size_t>& atoms : members) {
    points.clear();
    for (const std::size_t atom : atoms) gather(positions_[atom], seen, points);
    out.push_back(correlation_at(points));
    for (const std::size_t point : points) seen[point] = 0;
  }
  return out;
}

}  // namespace pliant
