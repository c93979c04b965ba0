// SPDX-License-Identifier: MIT
#include "pliant/framework/torsion_preferences.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <span>
#include <string>

#include "pliant/base/error.hpp"
#include "pliant/base/math/elementary.hpp"

namespace pliant {
namespace {

constexpr double pi = std::numbers::pi, radians = pi / 180.0;

/// An ellipse of the plot. Its long axis points to (along_phi, along_psi), a unit vector.
struct Region {
  double phi, psi;  ///< centre, radians
  double along_phi, along_psi;
  double per_long, per_short;  ///< one by half the axes, radians^-1
};

/// A region whose angles are given in degrees.
constexpr Region region(double phi, double psi, double along_phi, double along_psi,
                        double half_long, double half_short) {
  return {phi * radians,
          psi * radians,
          along_phi,
          along_psi,
          1.0 / (half_long * radians),
          1.0 / (half_short * radians)};
}

constexpr Region regions[] = {region(-110.0, 142.0, 1.0, 0.0, 61.0, 46.0),     // beta, polyproline
                              region(-120.0, -168.0, 1.0, 0.0, 52.0, 24.0),    // beta, psi past 180
                              region(-85.0, -22.0, -0.64, 0.768, 62.0, 31.0),  // alpha
                              region(-115.0, -30.0, 0.0, 1.0, 45.0, 36.0),  // alpha, phi further on
                              region(-116.0, 55.0, 0.0, 1.0, 48.0, 36.0),  // between alpha and beta
                              region(64.0, 25.0, -0.39, 0.921, 50.0, 21.0)};  // left-handed alpha

struct InRegion {
  double square;    ///< of the reach
  double phi, psi;  ///< from the centre, radians
};

double around(double angle) {
  if (angle > pi) return angle - 2.0 * pi;
  return angle < -pi ? angle + 2.0 * pi : angle;
}

InRegion in_region(const Region& region, double phi, double psi) {
  const double x = around(phi - region.phi), y = around(psi - region.psi);
  const double along = (x * region.along_phi + y * region.along_psi) * region.per_long;
  const double across = (x * region.along_psi - y * region.along_phi) * region.per_short;
  return {along * along + across * across, x, y};
}

InRegion nearest_region(double phi, double psi) {
  InRegion nearest{HUGE_VAL, 0.0, 0.0};
  for (const Region& region : regions)
    if (const InRegion place = in_region(region, phi, psi); place.square < nearest.square)
      nearest = place;
  return nearest;
}

void check_joints(std::span<const std::uint32_t> joints, std::size_t joint_count) {
  for (std::uint32_t joint : joints)
    if (joint >= joint_count)
      throw InputError("torsion preference: joint " + std::to_string(joint) + " of " +
                       std::to_string(joint_count));
  if (std::set<std::uint32_t>(joints.begin(), joints.end()).size() != joints.size())
    throw InputError("torsion preference: joint " + std::to_string(joints[0]) +
                     " and its neighbours are not all different");
}

/// The joints of a row.
template <std::size_t size>
std::array<std::uint32_t, size> row_at(const std::vector<std::uint32_t>& joints, std::size_t row) {
  std::array<std::uint32_t, size> at{};
  for (std::size_t k = 0; k < size; ++k) at[k] = joints[size * row + k];
  return at;
}

void check_rows(std::size_t joints, std::size_t rows, std::size_t size) {
  if (joints != rows * size)
    throw InputError("torsion preferences: " + std::to_string(joints) + " joints for " +
                     std::to_string(rows) + " rows of " + std::to_string(size));
}

}  // namespace

TorsionColumns columns_of(const TorsionPreferences& preferences) {
  TorsionColumns columns;
  for (const auto& [joints, free] : preferences.staggered) {
    columns.staggered.insert(columns.staggered.end(), joints.begin(), joints.end());
    columns.free.push_back(free);
  }
  for (const auto& [joints, reach] : preferences.backbone) {
    columns.backbone.insert(columns.backbone.end(), joints.begin(), joints.end());
    columns.reach.push_back(reach);
  }
  return columns;
}

TorsionPreferences torsion_preferences_of(const TorsionColumns& columns) {
  check_rows(columns.staggered.size(), columns.free.size(), 4);
  check_rows(columns.backbone.size(), columns.reach.size(), 5);
  TorsionPreferences made;
  for (std::size_t k = 0; k < columns.free.size(); ++k)
    made.staggered.push_back({row_at<4>(columns.staggered, k), columns.free[k]});
  for (std::size_t k = 0; k < columns.reach.size(); ++k)
    made.backbone.push_back({row_at<5>(columns.backbone, k), columns.reach[k]});
  return made;
}

void check(const TorsionPreferences& preferences, std::size_t joint_count) {
  for (const StaggeredTorsion& at : preferences.staggered) {
    check_joints(at.joints, joint_count);
    if (!(at.free >= 0.0 && at.free <= pi / 3.0 + 1e-9))
      throw InputError("torsion preference: free angle must be from 0 to pi / 3");
  }
  for (const BackboneTorsions& at : preferences.backbone) {
    check_joints(at.joints, joint_count);
    if (!(at.reach > 0.0 && std::isfinite(at.reach)))
      throw InputError("torsion preference: reach must be above 0 and finite");
  }
}

double torsion_angle(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  const Vec3 axis = c - b;
  const Vec3 one = cross(b - a, axis), other = cross(axis, d - c);
  return exact_bits_atan2(norm(axis) * dot(b - a, other), dot(one, other));
}

double off_staggered(double torsion) {
  if (torsion > 2.0 * pi / 3.0) return torsion - pi;
  if (torsion > 0.0) return torsion - pi / 3.0;
  return torsion > -2.0 * pi / 3.0 ? torsion + pi / 3.0 : torsion + pi;
}

double backbone_reach(double phi, double psi) { return std::sqrt(nearest_region(phi, psi).square); }

BackboneTurn backbone_turn(double phi, double psi, double reach) {
  for (const Region& region : regions)  // most are in one, and need not know the nearest
    if (in_region(region, phi, psi).square <= reach * reach) return {};
  const InRegion at = nearest_region(phi, psi);
  const double back = reach / std::sqrt(at.square) - 1.0;
  return {back * at.phi, back * at.psi};
}

}  // namespace pliant
