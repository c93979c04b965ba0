// SPDX-License-Identifier: MIT
// Puts the rigid units of a region back into their drawn shapes: what rounding has left of them
// after many steps would add up.
#pragma once

#include <span>
#include <vector>

#include "pliant/framework/framework.hpp"
#include "pliant/resolve/bodies/tree/body_plan.hpp"

namespace pliant {

/// A unit within a body: the places of its own joints, [first, last), and those over which it hangs
/// on what comes before it.
struct UnitPlaces {
  static constexpr Slot none = ~Slot{0};
  Slot first = 0, last = 0;
  Slot a = none, b = none;      ///< a hinge; equal for a ball joint; none: it moves freely
  std::uint32_t parent = none;  ///< an earlier unit, which carries it; none: it hangs on the ground
};

class DrawnShapes {
 public:
  /// The framework must outlive it.
  explicit DrawnShapes(const Framework& framework);

  /// Writes to `x` (places, Angstrom) where units are when each has its drawn shape and turns about
  /// its hinge against its parent as at `start` (places). That way errors do not grow from unit to
  /// unit. Does nothing if some unit is not as drawn (1e-6 Angstrom), or if the drawing has not all
  /// lengths to rounding.
  void restore(std::span<const UnitPlaces> units, std::span<const Joint> joint_at,
               std::span<const Vec3> start, std::span<Vec3> x);

 private:
  /// Right-handed axes at a point.
  struct Axes {
    Vec3 origin, along, across, up;
    Vec3 seen(Vec3 x) const {
      return {dot(x - origin, along), dot(x - origin, across), dot(x - origin, up)};
    }
    Vec3 put(Vec3 at) const { return origin + (at.x * along + at.y * across + at.z * up); }
  };
  struct Corners {
    Slot a, b, c;
  };

  /// Carries what moves with a unit from the start to its new place.
  struct Carried {
    Axes from, to;
    bool is_still = true;
    Vec3 operator()(Vec3 x) const { return is_still ? x : to.put(from.seen(x)); }
  };

  bool find_corners(const UnitPlaces& unit, std::span<const Joint> joint_at,
                    Corners& corners) const;
  static bool find_axes(Vec3 a, Vec3 b, Vec3 c, Axes& axes);
  bool restore_one(const UnitPlaces& unit, std::span<const Joint> joint_at,
                   std::span<const Vec3> start, std::span<Vec3> x);
  Carried parent_of(const UnitPlaces& unit) const {
    return unit.parent == UnitPlaces::none ? Carried{} : carried_[unit.parent];
  }

  std::span<const Vec3> drawn_;   ///< empty: not exact
  std::vector<Carried> carried_;  ///< (units)
};

}  // namespace pliant
