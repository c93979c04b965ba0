// SPDX-License-Identifier: MIT
#include "pliant/resolve/bodies/region/drawn_shapes.hpp"

#include <algorithm>
#include <cmath>

#include "pliant/framework/measures/residual.hpp"

namespace pliant {
namespace {

constexpr double exact = 1e-14;        // relative error of a drawn bar
constexpr double same_shape = 1e-6;    // Angstrom
constexpr double least_corner = 1e-4;  // sine: corners that are flatter give no direction

bool is_exact(const Framework& framework) {
  Tolerance tolerance;
  tolerance.relative = exact;
  return !framework.drawn().empty() && is_whole(framework, framework.drawn(), tolerance);
}

}  // namespace

DrawnShapes::DrawnShapes(const Framework& framework) {
  if (is_exact(framework)) drawn_ = framework.drawn();
}

void DrawnShapes::restore(std::span<const UnitPlaces> units, std::span<const Joint> joint_at,
                          std::span<const Vec3> start, std::span<Vec3> x) {
  if (drawn_.empty()) return;
  carried_.clear();
  for (const UnitPlaces& unit : units) {
    if (restore_one(unit, joint_at, start, x)) continue;
    std::copy(start.begin(), start.end(), x.begin());
    return;
  }
}

/// A unit without corners is carried as it is.
bool DrawnShapes::restore_one(const UnitPlaces& unit, std::span<const Joint> joint_at,
                              std::span<const Vec3> start, std::span<Vec3> x) {
  const Carried parent = parent_of(unit);
  const auto drawn = [&](Slot place) { return drawn_[joint_at[place]]; };
  const auto at_hinge = [&](Slot place) { return place < unit.first ? x[place] : start[place]; };
  Corners at{};
  Axes shape;
  Carried own;
  const bool has_corners = find_corners(unit, joint_at, at) &&
                           find_axes(drawn(at.a), drawn(at.b), drawn(at.c), shape) &&
                           find_axes(start[at.a], start[at.b], start[at.c], own.from) &&
                           find_axes(at_hinge(at.a), at_hinge(at.b), parent(start[at.c]), own.to);
  own.is_still = !has_corners;
  carried_.push_back(has_corners ? own : parent);
  for (Slot place = unit.first; place < unit.last; ++place) {
    x[place] = has_corners ? own.to.put(shape.seen(drawn(place))) : parent(start[place]);
    if (!(distance(x[place], carried_.back()(start[place])) <= same_shape)) return false;
  }
  return true;
}

/// Its hinge and an own place beside it; own places stand in for what a hinge does not have.
bool DrawnShapes::find_corners(const UnitPlaces& unit, std::span<const Joint> joint_at,
                               Corners& corners) const {
  Slot next = unit.first;
  const auto own_or = [&](Slot place) { return place != UnitPlaces::none ? place : next++; };
  corners.a = own_or(unit.a);
  corners.b = own_or(unit.a == unit.b ? UnitPlaces::none : unit.b);
  Axes axes;
  for (corners.c = next; corners.c < unit.last; ++corners.c)
    if (find_axes(drawn_[joint_at[corners.a]], drawn_[joint_at[corners.b]],
                  drawn_[joint_at[corners.c]], axes))
      return true;
  return false;
}

/// False where the three points are nearly on a line.
bool DrawnShapes::find_axes(Vec3 a, Vec3 b, Vec3 c, Axes& axes) {
  const Vec3 ab = b - a, ac = c - a;
  const double length = norm(ab);
  if (!(length > 0.0)) return false;
  axes.origin = a;
  axes.along = (1.0 / length) * ab;
  const Vec3 beside = ac - dot(ac, axes.along) * axes.along;
  const double width = norm(beside);
  if (!(width > least_corner * norm(ac))) return false;
  axes.across = (1.0 / width) * beside;
  axes.up = cross(axes.along, axes.across);
  return true;
}

}  // namespace pliant
