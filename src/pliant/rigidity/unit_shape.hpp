// SPDX-License-Identifier: MIT
// Shapes of rigid units: where the joints of each lie against one another.
#pragma once

#include <span>
#include <vector>

#include "pliant/framework/measures/residual.hpp"
#include "pliant/rigidity/unit_set.hpp"

namespace pliant {

/// What is known of the shape of a unit before any positions are seen.
enum class ShapeKind : std::uint8_t {
  rod,      ///< two joints: the rest length says all
  drawn,    ///< as the framework is drawn
  lengths,  ///< from a bar between each two joints: may be its own mirror image
  unknown,  ///< only its bars are known
};

struct UnitShapes {
  std::vector<ShapeKind> kinds;  ///< (U)
  /// As UnitSet::joints, from the first joint of its unit (Angstrom); none where the framework is
  /// drawn.
  std::vector<Vec3> points;
};

/// Where the joints of a unit lie, in the order of UnitSet::at (Angstrom), whether the framework is
/// drawn or the shape comes from lengths. Where drawn the points are gathered into `room`.
std::span<const Vec3> points_of(const Framework& framework, const UnitSet& set,
                                const UnitShapes& shapes, std::size_t unit,
                                std::vector<Vec3>& room);

/// The rest length of the bar between two joints (Angstrom); 0 if there is none.
double rod_length(const Framework& framework, Joint a, Joint b);

/// Takes drawn positions where the framework has them. Else places the joints of units whose joints
/// all have bars to each other by these lengths (classical multidimensional scaling: Torgerson,
/// Psychometrika 17 (1952) 401); lengths that fit no shape in space within the tolerance, and units
/// that lack a bar, are unknown.
UnitShapes find_unit_shapes(const Framework& framework, const UnitSet& set,
                            const Tolerance& tolerance);

}  // namespace pliant
