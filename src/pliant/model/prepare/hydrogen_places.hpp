// SPDX-License-Identifier: MIT
// Positions of hydrogens from the geometry of their parents. Cosines of multiples of 10 degrees
// come from a table, so that positions have the same bits on every machine.
#pragma once

#include "pliant/base/vec3.hpp"
#include "pliant/model/atoms/atom_graph.hpp"

namespace pliant {

/// The unit vector along `v`; an arbitrary unit vector if `v` has no direction.
Vec3 unit_vector(Vec3 v);

/// A unit vector at right angles to the unit vector `u`.
Vec3 perpendicular_to(Vec3 u);

/// Whether the bonds of an atom lie in a plane, as three of sp2 do.
bool is_planar(const Structure& structure, const AtomGraph& graph, std::uint32_t atom);

/// Cosine and sine of the angle at the parent.
struct BondAngle {
  double cosine, sine;
};
inline constexpr BondAngle tetrahedral_angle{-0.33380685923377096, 0.9426414910921784};  ///< 109.5
inline constexpr BondAngle planar_angle{-0.5, 0.8660254037844386};                       ///< 120
inline constexpr BondAngle thiol_angle{-0.10452846326765347, 0.9945218953682733};        ///< 96

/// cos of `tens` * 10 degrees.
double cosine_of_tens(int tens);

/// Positions about the bond from `neighbour` to `parent`, with torsions relative to `reference`.
class Spin {
 public:
  Spin(Vec3 reference, Vec3 neighbour, Vec3 parent);
  /// The position `length` Angstrom from the parent, at a torsion of `tens` * 10 degrees; 0 is cis
  /// to the reference.
  Vec3 at(double length, BondAngle angle, int tens) const;

 private:
  Vec3 parent_, along_, beside_, across_;
};

/// The position opposite to the sum of the bonds from `parent` to `one` and `other`.
Vec3 against_both(Vec3 parent, Vec3 one, Vec3 other, double length);

/// The position opposite to the sum of three bonds.
Vec3 against_three(Vec3 parent, Vec3 one, Vec3 other, Vec3 third, double length);

/// The position above (`side` = 1) or below (-1) the plane of two bonds, at the tetrahedral angle.
Vec3 out_of_plane(Vec3 parent, Vec3 one, Vec3 other, double length, double side);

}  // namespace pliant
