// SPDX-License-Identifier: MIT
// Where a hydrogen lies by the geometry of its parent. Cosines of whole tens of degrees are from a
// table, so that places have the same bits on every machine.
#pragma once

#include "pliant/base/vec3.hpp"

namespace pliant {

/// Along `v`, of length 1; some vector of length 1 where `v` has no direction.
Vec3 unit_vector(Vec3 v);

/// Of length 1 and at right angles to `u`, which has length 1.
Vec3 perpendicular_to(Vec3 u);

/// cos and sin of the angle at the parent.
struct BondAngle {
  double cosine, sine;
};
inline constexpr BondAngle tetrahedral_angle{-0.33380685923377096, 0.9426414910921784};  ///< 109.5
inline constexpr BondAngle planar_angle{-0.5, 0.8660254037844386};                       ///< 120
inline constexpr BondAngle thiol_angle{-0.10452846326765347, 0.9945218953682733};        ///< 96

/// cos of `tens` * 10 degrees.
double cosine_of_tens(int tens);

/// Places about the bond from `neighbour` to `parent`, torsions counted from `reference`.
class Spin {
 public:
  Spin(Vec3 reference, Vec3 neighbour, Vec3 parent);
  /// `length` Angstrom from the parent, at a torsion of `tens` * 10 degrees; 0: beside the
  /// reference.
  Vec3 at(double length, BondAngle angle, int tens) const;

 private:
  Vec3 parent_, along_, beside_, across_;
};

/// Against the sum of the bonds from `parent` to `one` and `other`.
Vec3 against_both(Vec3 parent, Vec3 one, Vec3 other, double length);

/// Above (`side` = 1) or below (-1) the plane of two bonds, at the tetrahedral angle.
Vec3 out_of_plane(Vec3 parent, Vec3 one, Vec3 other, double length, double side);

}  // namespace pliant
