// SPDX-License-Identifier: MIT
// Where a rigid unit comes to lie: turned as its joints fit best, about a point or about a line.
#pragma once

#include "pliant/base/math/best_fit.hpp"

namespace pliant {

/// A rigid unit that turns about a point (a ball joint, or its own centroid).
class TurnAboutPoint {
 public:
  explicit TurnAboutPoint(Vec3 point) : point_(point) {}

  /// A joint that lies at `from` the point in the unit, and should come to `target`.
  void add(Vec3 from, Vec3 target, double weight) { fit_.add(from, target - point_, weight); }

  /// Finds the best rotation; stays unturned unless that is fitted or mirrored.
  RotationFit::Fit fit(bool mirror_allowed) {
    const RotationFit::Fit fit = fit_.solve(mirror_allowed, rotation_);
    sign_ = fit == RotationFit::Fit::mirrored ? -1.0 : 1.0;
    return fit;
  }

  /// Where a joint comes to.
  Vec3 operator()(Vec3 from) const { return point_ + sign_ * rotation_(from); }

 private:
  Vec3 point_;
  RotationFit fit_;
  Rotation rotation_;
  double sign_ = 1.0;
};

/// A point of a unit seen from a hinge of it: along the axis from the hinge's first joint, and at
/// right angles to the axis along its AxisBasis (Angstrom).
struct HingePoint {
  double along = 0.0, u = 0.0, v = 0.0;
};

inline HingePoint seen_from(const AxisBasis& basis, Vec3 offset) {
  return {dot(offset, basis.axis), dot(offset, basis.e1), dot(offset, basis.e2)};
}

/// A rigid unit that turns about a hinge (torsion, dihedral angle).
class TurnAboutHinge {
 public:
  /// Where the hinge is: its first joint, and the axis from there to its second.
  TurnAboutHinge(Vec3 first, const AxisBasis& basis) : first_(first), basis_(basis) {}

  /// A joint that lies at `at` in the unit, and should come to `target`.
  void add(HingePoint at, Vec3 target, double weight) {
    const Vec3 offset = target - first_;
    fit_.add(at.u, at.v, dot(offset, basis_.e1), dot(offset, basis_.e2), weight);
  }

  /// The best turn; its strength may be 0, or no finite number.
  TorsionFit::Turn best(bool mirror_allowed) const { return fit_.solve(mirror_allowed); }
  void turn_by(const TorsionFit::Turn& turn) {
    u_ = turn.cosine * basis_.e1 + turn.sine * basis_.e2;
    v_ = turn.v_sign * (turn.cosine * basis_.e2 - turn.sine * basis_.e1);
  }

  /// Where a joint comes to, once turned.
  Vec3 operator()(HingePoint at) const {
    return first_ + (at.along * basis_.axis + at.u * u_ + at.v * v_);
  }

 private:
  Vec3 first_;
  AxisBasis basis_;
  TorsionFit fit_;
  Vec3 u_, v_;  ///< where the directions of HingePoint's u and v come to
};

}  // namespace pliant
