// SPDX-License-Identifier: MIT
// Shapes of rigid units: the relative positions of their joints.
#pragma once

#include <span>
#include <vector>

#include "pliant/framework/measures/residual.hpp"
#include "pliant/rigidity/unit_set.hpp"

namespace pliant {

/// What is known of the shape of a unit before any positions are seen.
enum class ShapeKind : std::uint8_t {
  rod,      ///< two joints, given by the rest length
  drawn,    ///< from the drawn positions of the framework
  lengths,  ///< from a bar between each two joints; the mirror image is possible, too
  unknown,  ///< only its bars are known
};

struct UnitShapes {
  std::vector<ShapeKind> kinds;  ///< (U)
  /// Positions of the joints of each unit relative to its first joint (Angstrom), in the order of
  /// UnitSet::things(); empty where the framework is drawn.
  std::vector<Vec3> points;
};

/// Positions of the joints of a unit in the order of UnitSet::at (Angstrom), from the drawn
/// positions or from lengths. Drawn positions are gathered into `room`.
std::span<const Vec3> points_of(const Framework& framework, const UnitSet& set,
                                const UnitShapes& shapes, std::size_t unit,
                                std::vector<Vec3>& room);

/// The rest length of the bar between two joints (Angstrom); 0 if there is none.
double rod_length(const Framework& framework, Joint a, Joint b);

/// Takes drawn positions where the framework has them. Otherwise places the joints of units that
/// have a bar between each two joints, by their lengths (classical multidimensional scaling:
/// Torgerson, Psychometrika 17 (1952) 401). Shapes are unknown where a bar is missing or where no
/// shape in space has these lengths within the tolerance.
UnitShapes find_unit_shapes(const Framework& framework, const UnitSet& set,
                            const Tolerance& tolerance);

}  // namespace pliant
