// SPDX-License-Identifier: MIT
// The shapes of rigid units that lengths alone do not tell from others nearby: a flat group that is
// a little off its plane has the same lengths as its mirror image.
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
  /// Units of four or more joints as the framework is drawn: those that bars to three joints each
  /// make rigid, and flat ones that are made of them by small loops (aromatic rings). None where
  /// the framework has no drawn positions, or is of the plane.
  KeptShapes(const Framework& framework, const Tolerance& tolerance);

  bool empty() const { return units_.size() == 0; }

  /// Notes the units that do not have their drawn shape at `positions` (N), by more than bars
  /// within their tolerance allow, and had it at `reference` (N, or none). True if there are any.
  bool find_bent(std::span<const Vec3> positions, std::span<const Vec3> reference);

  /// Brings the units noted, and those around them, near their drawn shapes: each is put where it
  /// fits best, each joint into the middle of where its units have it, again and again (as FRODA
  /// does: Wells et al., Phys. Biol. 2 (2005) S127). Keeps the centre of mass; leaves pinned
  /// joints.
  void straighten(std::span<Vec3> positions);

 private:
  /// Where the drawn shape comes to lie: x -> rotation(x - from) + to.
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
  std::vector<double> allowed_;  ///< how far a joint of each unit may be off its shape (Angstrom)
  UnitsOfJoints at_joint_{UnitSet{}, 0};
  std::vector<std::uint32_t> bent_, around_;  ///< around_: what is fitted with what is bent
  std::vector<std::uint8_t> is_around_;       ///< of units
  std::vector<Vec3> sums_;                    ///< (N)
  std::vector<double> counts_;                ///< (N) of units around that hold the joint
  std::vector<double> weights_;               ///< (N) in fits
};

}  // namespace pliant
