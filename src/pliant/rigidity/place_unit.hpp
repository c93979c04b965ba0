// SPDX-License-Identifier: MIT
// Best placement of a rigid unit, turned about a point or about a line.
#pragma once

#include "pliant/base/math/best_fit.hpp"

namespace pliant {

/// A rigid unit that turns about a point (a ball joint, or the unit's centroid).
class TurnAboutPoint {
 public:
  explicit TurnAboutPoint(Vec3 point) : point_(point) {}

  /// Adds a joint whose offset from the point is `from` in the unit, and which should come to
  /// `target`.
  void add(Vec3 from, Vec3 target, double weight) { fit_.add(from, target - point_, weight); }

  /// Finds the best rotation. The unit is not turned unless the result is fitted or mirrored.
  RotationFit::Fit fit(bool mirror_allowed) {
    const RotationFit::Fit fit = fit_.solve(mirror_allowed, rotation_);
    sign_ = fit == RotationFit::Fit::mirrored ? -1.0 : 1.0;
    return fit;
  }

  /// Position of a joint in the turned unit.
  Vec3 operator()(Vec3 from) const { return point_ + sign_ * rotation_(from); }

 private:
  Vec3 point_;
  RotationFit fit_;
  Rotation rotation_;
  double sign_ = 1.0;
};

/// A point of a unit relative to a hinge: its distance along the axis from the hinge's first joint,
/// and its components along the two directions of AxisBasis at right angles to the axis (Angstrom).
struct HingePoint {
  double along = 0.0, u = 0.0, v = 0.0;
};

inline HingePoint seen_from(const AxisBasis& basis, Vec3 offset) {
  return {dot(offset, basis.axis), dot(offset, basis.e1), dot(offset, basis.e2)};
}

/// A rigid unit that turns about a hinge (torsion, dihedral angle).
class TurnAboutHinge {
 public:
  /// Takes the hinge's first joint, and a basis whose axis points from there to its second.
  TurnAboutHinge(Vec3 first, const AxisBasis& basis) : first_(first), basis_(basis) {}

  /// Adds a joint whose position in the unit is `at`, and which should come to `target`.
  void add(HingePoint at, Vec3 target, double weight) {
    const Vec3 offset = target - first_;
    fit_.add(at.u, at.v, dot(offset, basis_.e1), dot(offset, basis_.e2), weight);
  }

  /// The best turn. Its strength may be 0 or not finite.
  TorsionFit::Turn best(bool mirror_allowed) const { return fit_.solve(mirror_allowed); }
  void turn_by(const TorsionFit::Turn& turn) {
    u_ = turn.cosine * basis_.e1 + turn.sine * basis_.e2;
    v_ = turn.v_sign * (turn.cosine * basis_.e2 - turn.sine * basis_.e1);
  }

  /// Position of a joint in the turned unit.
  Vec3 operator()(HingePoint at) const {
    return first_ + (at.along * basis_.axis + at.u * u_ + at.v * v_);
  }

 private:
  Vec3 first_;
  AxisBasis basis_;
  TorsionFit fit_;
  Vec3 u_, v_;  ///< the directions of HingePoint's u and v after the turn
};

}  // namespace pliant
