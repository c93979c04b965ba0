// SPDX-License-Identifier: MIT
// The outward pass over rigid units: each is placed as a whole, exactly, where it fits its joints
// best, as far as earlier placements allow. Every joint is written once.
//
//   free   R = argmin sum w |t - tm - R (s - sm)|^2      (Horn 1987), x = tm + R (s - sm)
//   ball   the same about the joint shared with what is placed
//   hinge  tan t = sum w (u t2 - v t1) / sum w (u t1 + v t2), x = a + z n + turned (u, v)
//
// s: shape, t: present joints, n: along the hinge. Shapes are drawn or known from lengths to
// rounding and every placement is a rigid motion to rounding, so that the bars of the last unit of
// a chain are as exact as those of the first. Two units share at most a hinge. Therefore a molecule
// whose bars fix all bonds and angles is exact after one pass.
#pragma once

#include <memory>
#include <vector>

#include "pliant/resolve/bodies/outward/unit_ahead.hpp"
#include "pliant/resolve/bodies/outward/unit_loop.hpp"
#include "pliant/resolve/bodies/outward/unit_plan.hpp"
#include "pliant/resolve/method/plan_of_root.hpp"

namespace pliant {

class UnitPass {
 public:
  /// `units` are those of find_units(); the framework must outlive it.
  UnitPass(const Framework& framework, UnitSet units, const Technique& technique,
           const ResolveOptions& options);

  enum class Placement { placed, unfit, not_finite };
  /// Finds the shapes of units without one, each separately, then places all. unfit: a unit was not
  /// changed (no shape, or all joints at one point), or pinned joints do not fit one.
  Placement run(const ResolveCall& call);

  /// After run(): places all again near `targets` (N), looking ahead (UnitAhead). unfit: as in
  /// run(), or if some unit has no direction; positions are then undefined.
  Placement look_ahead(const ResolveCall& call, std::span<const Vec3> targets);

 private:
  void make_loops(const Technique& technique, const ResolveOptions& options);
  void make_loop(std::uint32_t unit, std::span<const BarIndex> bars, const Technique& technique,
                 const ResolveOptions& options);
  void close_by_torsions(const ResolveOptions& options);
  Placement place(const ResolveCall& call, UnitStep& step);
  Placement place_by(const UnitStep::Free&, const ResolveCall& call, const UnitStep& step);
  Placement place_by(const UnitStep::Still&, const ResolveCall& call, const UnitStep& step);
  Placement place_by(const UnitStep::Ball&, const ResolveCall& call, const UnitStep& step);
  Placement place_by(const UnitStep::Hinge& hinge, const ResolveCall& call, const UnitStep& step);
  Placement place_by(const UnitStep::Rod& rod, const ResolveCall& call, const UnitStep& step);
  Placement place_about(Vec3 point, std::span<Vec3> positions, const UnitStep& step);
  TorsionFit::Turn any_turn(RandomKey key, const UnitStep::Hinge& hinge, double length) const;
  void place_still(const ResolveCall& call, const UnitStep& step) const;

  const Framework& framework_;
  UnitForest forest_;
  UnitPlan plan_;
  std::vector<std::unique_ptr<UnitLoop>> loops_;  ///< of units without a shape
  std::vector<UnitLoop*> loop_of_;                ///< of each unit up to the last that has one
  UnitAhead ahead_;
  PlanOfRoot planned_;
};

}  // namespace pliant
