// SPDX-License-Identifier: MIT
#include "pliant/framework/torsion_preferences.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <span>
#include <string>

#include "pliant/base/elementary.hpp"
#include "pliant/base/error.hpp"

namespace pliant {
namespace {

constexpr double pi = std::numbers::pi, radians = pi / 180.0;

/// A region of the plot: degrees; the long axis points to (along_phi, along_psi), a unit vector.
struct Region {
  double phi, psi, along_phi, along_psi, half_long, half_short;
};

constexpr Region regions[] = {{-110.0, 142.0, 1.0, 0.0, 61.0, 46.0},     // beta, polyproline
                              {-120.0, -168.0, 1.0, 0.0, 52.0, 24.0},    // beta, psi past 180
                              {-85.0, -22.0, -0.64, 0.768, 62.0, 31.0},  // alpha
                              {-115.0, -30.0, 0.0, 1.0, 45.0, 36.0},     // alpha, phi further on
                              {-116.0, 55.0, 0.0, 1.0, 48.0, 36.0},      // between alpha and beta
                              {64.0, 25.0, -0.39, 0.921, 50.0, 21.0}};   // left-handed alpha

struct InRegion {
  double reach, phi, psi;  ///< phi and psi from the centre, radians
};

double around(double angle) {
  if (angle > pi) return angle - 2.0 * pi;
  return angle < -pi ? angle + 2.0 * pi : angle;
}

InRegion in_region(const Region& region, double phi, double psi) {
  const double x = around(phi - region.phi * radians), y = around(psi - region.psi * radians);
  const double along = (x * region.along_phi + y * region.along_psi) / (region.half_long * radians);
  const double across =
      (x * region.along_psi - y * region.along_phi) / (region.half_short * radians);
  return {std::sqrt(along * along + across * across), x, y};
}

InRegion nearest_region(double phi, double psi) {
  InRegion nearest{HUGE_VAL, 0.0, 0.0};
  for (const Region& region : regions)
    if (const InRegion place = in_region(region, phi, psi); place.reach < nearest.reach)
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

double cosine_of_torsion(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  const Vec3 one = cross(b - a, c - b), other = cross(c - b, d - c);
  const double square = norm_squared(one) * norm_squared(other);
  return square > 0.0 ? std::clamp(dot(one, other) / std::sqrt(square), -1.0, 1.0) : 1.0;
}

double torsion_angle(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  const double angle = exact_bits_acos(cosine_of_torsion(a, b, c, d));
  return dot(b - a, cross(c - b, d - c)) < 0.0 ? -angle : angle;
}

double off_staggered(double torsion) {
  if (torsion > 2.0 * pi / 3.0) return torsion - pi;
  if (torsion > 0.0) return torsion - pi / 3.0;
  return torsion > -2.0 * pi / 3.0 ? torsion + pi / 3.0 : torsion + pi;
}

double backbone_reach(double phi, double psi) { return nearest_region(phi, psi).reach; }

BackboneTurn backbone_turn(double phi, double psi, double reach) {
  const InRegion at = nearest_region(phi, psi);
  if (at.reach <= reach) return {};
  const double back = reach / at.reach - 1.0;
  return {back * at.phi, back * at.psi};
}

}  // namespace pliant
