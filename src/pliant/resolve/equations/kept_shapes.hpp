// SPDX-License-Identifier: MIT
// Shapes of rigid units that have neighbours with the same lengths: a flat group slightly off its
// plane has the same lengths as its mirror image.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "pliant/base/math/best_fit.hpp"
#include "pliant/framework/measures/residual.hpp"
#include "pliant/rigidity/unit_set.hpp"

namespace pliant {

class KeptShapes {
 public:
  /// Takes units of four or more joints as the framework is drawn: those made rigid by bars to
  /// three joints each, and flat ones joined from these by small loops (aromatic rings). None if
  /// the framework has no drawn positions, or is planar.
  KeptShapes(const Framework& framework, const Tolerance& tolerance);

  bool empty() const { return units_.size() == 0; }

  /// Notes the units that deviate from their drawn shape at `positions` (N) by more than bars
  /// within their tolerance allow, but did not at `reference` (N, or none). Returns whether there
  /// are any.
  bool find_bent(std::span<const Vec3> positions, std::span<const Vec3> reference);

  /// Brings these units, and those around them, near their drawn shapes: repeatedly, each unit is
  /// placed where it fits best, and each joint at the mean of its positions in its units (as FRODA
  /// does: Wells et al., Phys. Biol. 2 (2005) S127). Keeps the centre of mass; does not move pinned
  /// joints.
  void straighten(std::span<Vec3> positions);

 private:
  /// Placement of the drawn shape: x -> rotation(x - from) + to.
  struct Fit {
    Vec3 from, to;
    Rotation rotation;
    Vec3 operator()(Vec3 x) const { return rotation(x - from) + to; }
  };

  void add(std::span<const Joint> joints);
  Fit fit(std::size_t unit, std::span<const Vec3> positions) const;
  bool is_bent(std::size_t unit, std::span<const Vec3> positions) const;
  void find_around();
  void weigh();
  double mass(Joint joint) const;
  void clear_sums();
  bool add_places(std::span<const Vec3> positions);

  const Framework& framework_;
  Tolerance tolerance_;
  UnitSet units_;
  /// largest deviation of a joint of each unit from its shape (Angstrom)
  std::vector<double> allowed_;
  UnitsOfJoints at_joint_{UnitSet{}, 0};
  std::vector<std::uint32_t> bent_, around_;  ///< around_: units fitted together with the bent ones
  std::vector<std::uint8_t> is_around_;       ///< (units)
  std::vector<Vec3> sums_;                    ///< (N)
  std::vector<double> counts_;                ///< (N) number of units in around_ with the joint
  std::vector<double> weights_;               ///< (N) in fits
};

}  // namespace pliant
