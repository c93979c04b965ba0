// SPDX-License-Identifier: MIT
// The plan of an outward pass over rigid units: the order of the units, the joints that connect
// each to earlier ones, and the coordinates of its other joints relative to these.
#pragma once

#include <span>
#include <variant>
#include <vector>

#include "pliant/rigidity/place_unit.hpp"
#include "pliant/rigidity/unit_graph.hpp"
#include "pliant/rigidity/unit_shape.hpp"

namespace pliant {

/// The links of a graph of units, in a fifth of the memory.
struct UnitLinks {
  std::size_t units = 0;
  std::vector<UnitConnection> connections;
  Grouped<UnitNode> neighbours;  ///< of each node, in the graph's sequence

  const UnitConnection& connection(UnitNode node) const { return connections[node - units]; }
};

/// The units of a framework, as a forest.
struct UnitForest {
  UnitSet set;        ///< without any loops
  UnitLinks links;    ///< of `set`
  UnitShapes shapes;  ///< of `set`; loops with freedom are unknown
  UnitSet rigid;      ///< units whose shape is known if drawn or complete; none if `set` has them
  std::vector<std::uint32_t> of_rigid;  ///< the unit in `set` that contains each rigid one

  bool has_unknown() const;
};

UnitForest find_unit_forest(const Framework& framework, UnitSet units, const Tolerance& tolerance);

/// A joint to place, or to be moved along with a fixed unit or a rod.
class JointInUnit {
 public:
  Joint joint = 0;
  double weight = 1.0;  ///< in the fit; 1 for the heaviest joint of a unit

  /// In a unit that turns about a point: position relative to it (Angstrom).
  Vec3 from_point() const { return {at_.along, at_.u, at_.v}; }
  void set_from_point(Vec3 from) { at_ = {from.x, from.y, from.z}; }
  /// In a unit that turns about a hinge.
  HingePoint from_hinge() const { return at_; }
  void set_from_hinge(HingePoint at) { at_ = at; }

 private:
  HingePoint at_;
};

/// One unit to place. The coordinates of its joints are relative to what it turns about.
struct UnitStep {
  /// No joint is placed: best fit, turned about the weighted centroid.
  struct Free {};
  /// No joint is placed, and it has its shape already: does not move.
  struct Still {};
  /// Shares joint `a` with placed units: best rotation about it.
  struct Ball {};
  /// Shares joints `a` and `b`: best torsion about the line through them.
  struct Hinge {
    Joint b;
    double length = 0.0;  ///< Angstrom
    double spread = 0.0;  ///< sum of weight times squared distance from the line
  };
  /// Two joints, of which `a` is placed: `b` is placed on the line through them.
  struct Rod {
    Joint b;
    double length = 0.0;  ///< Angstrom
  };
  using Entry = std::variant<Free, Still, Ball, Hinge, Rod>;

  Entry entry;         ///< its connection to placed units
  double scale = 1.0;  ///< of the weights: mass of the heaviest joint (u), or 1
  std::uint32_t unit = 0;
  Joint a = 0;                         ///< the shared joint; any joint of a free or still unit
  std::uint32_t first = 0, count = 0;  ///< joints to place, in UnitPlan::joints
  std::int32_t parent = -1;  ///< the step of the unit that it hangs on; -1: first of its component
  bool mirror_allowed = false;
  bool is_held = false;  ///< connected to pinned joints only
  bool is_known = true;  ///< otherwise its shape is to be set each time

  template <class Kind>
  bool is() const {
    return std::holds_alternative<Kind>(entry);
  }
  /// Whether it begins a component without pinned joints, which moves as a whole.
  bool moves_freely() const { return parent < 0 && !is_held; }
  /// Degrees of freedom of its turns relative to placed units: 1 for a hinge.
  std::size_t turns() const {
    if (is<Rod>()) return 2;  // not about itself
    if (is<Still>() || moves_freely()) return 0;
    return is<Hinge>() ? 1 : 3;
  }
};

/// Plans passes from any root; linear in joints.
class UnitPlan {
 public:
  /// Both must outlive it. Fits are weighted by mass, or all joints have equal weights.
  UnitPlan(const Framework& framework, const UnitForest& forest, bool mass_weighted);

  /// A component with pinned joints begins at the unit that holds them all, and is left out if
  /// there is none. The root's component begins at a unit of the root, others at a unit of their
  /// lowest joint.
  void plan(Joint root);

  std::span<UnitStep> steps() { return steps_; }
  std::span<JointInUnit> joints(const UnitStep& step) {
    return {joints_.data() + step.first, step.count};
  }
  /// Writes the positions of the joints of a step, from the shape of its unit (as UnitSet::at).
  void set_shape(UnitStep& step, std::span<const Vec3> points);

 private:
  void find_pins();
  void start_at(Joint joint, std::span<const Joint> pins);
  void spread(std::uint32_t unit);
  void add_step(std::uint32_t unit, Joint a, UnitStep::Entry entry);
  void add_joints(UnitStep& step);
  bool holds_all(std::uint32_t unit, std::span<const Joint> joints) const;
  void set_hinge(const UnitStep& step, UnitStep::Hinge& hinge, std::span<const Vec3> points);
  Vec3 point_of(const UnitStep& step, std::span<const Vec3> points, Joint joint) const;

  const Framework& framework_;
  const UnitForest& forest_;
  bool mass_weighted_;
  UnitsOfJoints units_of_;
  std::vector<std::vector<Joint>> pins_;  ///< of each component with pinned joints
  std::vector<UnitStep> steps_;
  std::vector<JointInUnit> joints_;
  std::vector<bool> seen_;    ///< nodes of the graph of units
  std::vector<bool> placed_;  ///< joints
  std::vector<std::uint32_t> waiting_;
  std::vector<std::int32_t> step_of_;  ///< of units
  std::vector<Vec3> points_;           ///< of the present unit
};

}  // namespace pliant
