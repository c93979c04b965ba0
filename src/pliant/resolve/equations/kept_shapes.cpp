// SPDX-License-Identifier: MIT
#include "pliant/resolve/equations/kept_shapes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "pliant/rigidity/unit_graph.hpp"

namespace pliant {
namespace {

constexpr std::size_t fewest_joints = 4;  // three have no mirror image
/// Share of a unit's radius: what turns a torsion by less than a degree.
constexpr double most_off = 0.002;
/// Thickness of what is flat, in widths.
constexpr double thinnest = 0.1;
/// By so many units away from a bent one, and so often, shapes are fitted until they agree.
constexpr std::size_t shells = 3;
constexpr int most_rounds = 100;
/// Share of what a joint may be off the shape of its unit.
constexpr double well_enough = 0.01;

Vec3 centroid(std::span<const Joint> joints, std::span<const Vec3> positions) {
  Vec3 sum;
  for (Joint joint : joints) sum += positions[joint];
  return (1.0 / double(joints.size())) * sum;
}

/// Whether the joints lie near one plane: by the least of their principal moments.
bool is_flat(std::span<const Joint> joints, std::span<const Vec3> positions) {
  const Vec3 middle = centroid(joints, positions);
  std::array<double, 9> moments{}, axes{};
  for (Joint joint : joints) {
    const Vec3 r = positions[joint] - middle;
    const std::array x = {r.x, r.y, r.z};
    for (std::size_t i = 0; i < 9; ++i) moments[i] += x[i / 3] * x[i % 3];
  }
  find_eigenvectors(moments, axes, 3);
  const auto [least, most] = std::minmax({moments[0], moments[4], moments[8]});
  return least <= thinnest * thinnest * most;
}

}  // namespace

KeptShapes::KeptShapes(const Framework& framework, const Tolerance& tolerance)
    : framework_(framework), tolerance_(tolerance) {
  if (framework.drawn().empty() || framework.is_planar()) return;
  const UnitSet rigid = find_units(framework);
  const auto is_large = [](std::span<const Joint> joints) {
    return joints.size() >= fewest_joints;
  };
  bool any = false;
  for (std::size_t k = 0; k < rigid.size(); ++k) any = any || is_large(rigid.at(k));
  if (!any) return;
  const MergedUnits merged = merge_rigid_loops(framework, rigid);
  std::vector<std::uint8_t> flat(merged.set.size());
  for (std::size_t k = 0; k < merged.set.size(); ++k) {
    flat[k] = is_large(merged.set.at(k)) && is_flat(merged.set.at(k), framework.drawn());
    if (flat[k]) add(merged.set.at(k));
  }
  for (std::size_t k = 0; k < rigid.size(); ++k)
    if (is_large(rigid.at(k)) && !flat[merged.of_unit[k]]) add(rigid.at(k));
  at_joint_ = UnitsOfJoints(units_, framework.joint_count());
  weights_.assign(framework.joint_count(), 1.0);
}

void KeptShapes::add(std::span<const Joint> joints) {
  const Vec3 middle = centroid(joints, framework_.drawn());
  double radius = 0.0;
  for (Joint joint : joints) radius = std::max(radius, distance(framework_.drawn()[joint], middle));
  // Bars across a flat unit are at their longest: an error e of one of length L lets an atom leave
  // the plane by the root of 2 L e.
  const double by_tolerance = std::sqrt(2.0 * radius * tolerance_.of(radius));
  units_.add(joints);
  allowed_.push_back(std::max(most_off * radius, by_tolerance));
}

KeptShapes::Fit KeptShapes::fit(std::size_t unit, std::span<const Vec3> positions) const {
  const auto joints = units_.at(unit);
  const auto drawn = framework_.drawn();
  Fit found;
  double sum = 0.0;
  for (Joint joint : joints) {
    found.from += weights_[joint] * drawn[joint];
    found.to += weights_[joint] * positions[joint];
    sum += weights_[joint];
  }
  found.from = (1.0 / sum) * found.from;
  found.to = (1.0 / sum) * found.to;
  RotationFit rotation;
  for (Joint joint : joints)
    rotation.add(drawn[joint] - found.from, positions[joint] - found.to, weights_[joint]);
  if (rotation.solve(false, found.rotation) != RotationFit::Fit::fitted) found.rotation = {};
  return found;
}

bool KeptShapes::is_bent(std::size_t unit, std::span<const Vec3> positions) const {
  const Fit at = fit(unit, positions);
  const auto joints = units_.at(unit);
  return std::any_of(joints.begin(), joints.end(), [&](Joint joint) {
    return distance(at(framework_.drawn()[joint]), positions[joint]) > allowed_[unit];
  });
}

bool KeptShapes::find_bent(std::span<const Vec3> positions, std::span<const Vec3> reference) {
  bent_.clear();
  for (std::uint32_t k = 0; k < units_.size(); ++k)
    if (is_bent(k, positions) && (reference.empty() || !is_bent(k, reference))) bent_.push_back(k);
  return !bent_.empty();
}

void KeptShapes::straighten(std::span<Vec3> positions) {
  find_around();
  weigh();
  sums_.resize(framework_.joint_count());
  for (int round = 0; round < most_rounds; ++round) {
    clear_sums();
    const bool agree = add_places(positions);
    for (std::uint32_t unit : around_)
      for (Joint joint : units_.at(unit))
        if (!framework_.is_pinned(joint)) positions[joint] = (1.0 / counts_[joint]) * sums_[joint];
    if (agree) break;
  }
  weights_.assign(framework_.joint_count(), 1.0);
}

void KeptShapes::clear_sums() {
  for (std::uint32_t unit : around_)
    for (Joint joint : units_.at(unit)) sums_[joint] = {};
}

/// Shared among the units of a joint, so that the centre of mass stays where it is.
void KeptShapes::weigh() {
  counts_.assign(framework_.joint_count(), 0.0);
  for (std::uint32_t unit : around_)
    for (Joint joint : units_.at(unit)) ++counts_[joint];
  for (std::uint32_t unit : around_)
    for (Joint joint : units_.at(unit)) weights_[joint] = mass(joint) / counts_[joint];
}

double KeptShapes::mass(Joint joint) const {
  const double inverse = framework_.inverse_masses()[joint];
  return inverse > 0.0 ? 1.0 / inverse : 1.0;
}

/// Where each unit fits best; whether all do so well that nothing is left to gain.
bool KeptShapes::add_places(std::span<const Vec3> positions) {
  bool agree = true;
  for (std::uint32_t unit : around_) {
    const Fit at = fit(unit, positions);
    for (Joint joint : units_.at(unit)) {
      const Vec3 place = at(framework_.drawn()[joint]);
      agree = agree && distance(place, positions[joint]) <= well_enough * allowed_[unit];
      sums_[joint] += place;
    }
  }
  return agree;
}

void KeptShapes::find_around() {
  around_ = bent_;
  is_around_.assign(units_.size(), 0);
  for (std::uint32_t unit : around_) is_around_[unit] = 1;
  for (std::size_t shell = 0, from = 0; shell < shells; ++shell)
    for (const std::size_t to = around_.size(); from < to; ++from)
      for (Joint joint : units_.at(around_[from]))
        for (std::uint32_t unit : at_joint_.at(joint)) {
          if (is_around_[unit]) continue;
          is_around_[unit] = 1;
          around_.push_back(unit);
        }
}

}  // namespace pliant
