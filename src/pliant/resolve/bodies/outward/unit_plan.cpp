// SPDX-License-Identifier: MIT
#include "pliant/resolve/bodies/outward/unit_plan.hpp"

#include <algorithm>
#include <map>

#include "pliant/framework/graph.hpp"

namespace pliant {
namespace {

UnitLinks links_of(const UnitGraph& graph) {
  UnitLinks links{graph.units, graph.connections, {}};
  const std::size_t nodes = graph.links.node_count();
  links.neighbours.reserve(nodes, 2 * graph.links.edge_count());
  std::vector<UnitNode> around;
  for (UnitNode node = 0; node < nodes; ++node) {
    around.clear();
    for (const Link& link : graph.links.at(node)) around.push_back(link.node);
    links.neighbours.add(around);
  }
  return links;
}

/// Units made of several rigid ones have no shape of their own.
void forget_loops(UnitForest& forest) {
  std::vector<std::uint32_t> parts(forest.set.size(), 0);
  for (std::uint32_t unit : forest.of_rigid) ++parts[unit];
  for (std::size_t unit = 0; unit < forest.set.size(); ++unit)
    if (parts[unit] > 1) forest.shapes.kinds[unit] = ShapeKind::unknown;
}

}  // namespace

bool UnitForest::has_unknown() const {
  return std::find(shapes.kinds.begin(), shapes.kinds.end(), ShapeKind::unknown) !=
         shapes.kinds.end();
}

UnitForest find_unit_forest(const Framework& framework, UnitSet units, const Tolerance& tolerance) {
  // Without drawn positions the shape of a rigid loop is found each time, from the units on it.
  if (!framework.drawn().empty())
    units = std::move(merge_rigid_loops(framework, std::move(units)).set);
  UnitForest forest;
  forest.rigid = std::move(units);
  {
    MergedUnits all = merge_all_loops(framework, forest.rigid);
    forest.set = std::move(all.set);
    forest.of_rigid = std::move(all.of_unit);
  }
  forest.links = links_of(connect_units(framework, forest.set));
  forest.shapes = find_unit_shapes(framework, forest.set, tolerance);
  forget_loops(forest);
  if (!forest.has_unknown()) {
    forest.rigid = {};
    forest.of_rigid = {};
  }
  return forest;
}

UnitPlan::UnitPlan(const Framework& framework, const UnitForest& forest, bool mass_weighted)
    : framework_(framework),
      forest_(forest),
      mass_weighted_(mass_weighted),
      units_of_(forest.set, framework.joint_count()) {
  find_pins();
}

void UnitPlan::find_pins() {
  if (!framework_.has_pinned_joints()) return;
  const Components components = find_components(framework_);
  std::map<std::uint32_t, std::vector<Joint>> by_component;
  for (Joint joint = 0; joint < framework_.joint_count(); ++joint)
    if (framework_.is_pinned(joint)) by_component[components.of_node[joint]].push_back(joint);
  for (auto& [component, joints] : by_component) pins_.push_back(std::move(joints));
}

void UnitPlan::plan(Joint root) {
  steps_.clear();
  steps_.reserve(forest_.set.size());
  joints_.clear();
  joints_.reserve(framework_.joint_count());
  seen_.assign(forest_.links.neighbours.size(), false);
  placed_.assign(framework_.joint_count(), false);
  step_of_.assign(forest_.set.size(), -1);
  for (const auto& pins : pins_) start_at(pins[0], pins);
  if (framework_.joint_count() > 0) start_at(root, {});
  for (Joint joint = 0; joint < framework_.joint_count(); ++joint) start_at(joint, {});
}

void UnitPlan::start_at(Joint joint, std::span<const Joint> pins) {
  const auto units = units_of_.at(joint);
  if (units.empty() || seen_[units[0]]) return;
  const auto holder = std::find_if(units.begin(), units.end(),
                                   [&](std::uint32_t unit) { return holds_all(unit, pins); });
  const std::uint32_t unit = holder == units.end() ? units[0] : *holder;
  const std::size_t steps_before = steps_.size(), joints_before = joints_.size();
  const bool is_unknown = forest_.shapes.kinds[unit] == ShapeKind::unknown;
  const bool is_rod = forest_.shapes.kinds[unit] == ShapeKind::rod;
  waiting_.assign(1, unit);
  seen_[unit] = true;
  for (Joint pin : pins) placed_[pin] = true;
  if (is_unknown) {
    add_step(unit, joint, UnitStep::Still{});
  } else if (is_rod) {
    const auto ends = forest_.set.at(unit);
    if (pins.size() < 2) add_step(unit, joint, UnitStep::Rod{ends[0] == joint ? ends[1] : ends[0]});
  } else if (pins.size() == 2 && holder != units.end()) {
    add_step(unit, pins[0], UnitStep::Hinge{pins[1]});
  } else if (pins.empty()) {
    add_step(unit, joint, UnitStep::Free{});
  } else {
    add_step(unit, joint, UnitStep::Ball{});
  }
  if (steps_.size() > steps_before) steps_.back().is_held = !pins.empty();
  for (std::size_t next = 0; next < waiting_.size(); ++next) spread(waiting_[next]);
  if (holder != units.end() && (pins.size() <= 2 || is_unknown)) return;
  steps_.resize(steps_before);  // pins that no unit can meet alone: left to others
  joints_.resize(joints_before);
}

bool UnitPlan::holds_all(std::uint32_t unit, std::span<const Joint> joints) const {
  const auto members = forest_.set.at(unit);
  return std::all_of(joints.begin(), joints.end(), [&](Joint joint) {
    return std::binary_search(members.begin(), members.end(), joint);
  });
}

void UnitPlan::spread(std::uint32_t unit) {
  for (const UnitNode to : forest_.links.neighbours.at(unit)) {
    if (seen_[to]) continue;
    seen_[to] = true;
    const UnitConnection& at = forest_.links.connection(to);
    for (const UnitNode next : forest_.links.neighbours.at(to)) {
      if (seen_[next]) continue;
      seen_[next] = true;
      waiting_.push_back(next);
      const auto ends = forest_.set.at(next);
      if (forest_.shapes.kinds[next] == ShapeKind::rod) {
        add_step(next, at.a, UnitStep::Rod{ends[0] == at.a ? ends[1] : ends[0]});
      } else if (at.is_hinge()) {
        add_step(next, at.a, UnitStep::Hinge{at.b});
      } else {
        add_step(next, at.a, UnitStep::Ball{});
      }
      steps_.back().parent = step_of_[unit];
      steps_.back().is_held = step_of_[unit] < 0;
    }
  }
}

void UnitPlan::add_step(std::uint32_t unit, Joint a, UnitStep::Entry entry) {
  UnitStep step;
  step.unit = unit;
  step.entry = entry;
  step.a = a;
  const ShapeKind kind = forest_.shapes.kinds[unit];
  step.mirror_allowed = kind == ShapeKind::lengths;
  step.is_known = kind != ShapeKind::unknown;
  if (step.is<UnitStep::Ball>()) placed_[a] = true;
  auto* rod = std::get_if<UnitStep::Rod>(&step.entry);
  if (rod != nullptr) rod->length = rod_length(framework_, a, rod->b);
  add_joints(step);
  if (step.is_known && rod == nullptr)
    set_shape(step, points_of(framework_, forest_.set, forest_.shapes, unit, points_));
  step_of_[unit] = static_cast<std::int32_t>(steps_.size());
  steps_.push_back(step);
}

void UnitPlan::add_joints(UnitStep& step) {
  step.first = static_cast<std::uint32_t>(joints_.size());
  for (Joint joint : forest_.set.at(step.unit)) {
    if (placed_[joint]) continue;
    placed_[joint] = true;
    const double weight = mass_weighted_ ? 1.0 / framework_.inverse_masses()[joint] : 1.0;
    JointInUnit added;
    added.joint = joint;
    added.weight = weight;
    joints_.push_back(added);
  }
  step.count = static_cast<std::uint32_t>(joints_.size()) - step.first;
  double heaviest = 0.0;
  for (const JointInUnit& joint : joints(step)) heaviest = std::max(heaviest, joint.weight);
  for (JointInUnit& joint : joints(step)) joint.weight /= heaviest;
  step.scale = heaviest;
}

Vec3 UnitPlan::point_of(const UnitStep& step, std::span<const Vec3> points, Joint joint) const {
  const auto members = forest_.set.at(step.unit);
  return points[std::size_t(std::lower_bound(members.begin(), members.end(), joint) -
                            members.begin())];
}

void UnitPlan::set_shape(UnitStep& step, std::span<const Vec3> points) {
  if (auto* hinge = std::get_if<UnitStep::Hinge>(&step.entry))
    return set_hinge(step, *hinge, points);
  Vec3 origin;
  double sum = 0.0;
  for (JointInUnit& joint : joints(step)) {
    const Vec3 point = point_of(step, points, joint.joint);
    joint.set_from_point(point);
    origin += joint.weight * point;
    sum += joint.weight;
  }
  origin = step.is<UnitStep::Ball>() ? point_of(step, points, step.a) : (1.0 / sum) * origin;
  for (JointInUnit& joint : joints(step)) joint.set_from_point(joint.from_point() - origin);
}

void UnitPlan::set_hinge(const UnitStep& step, UnitStep::Hinge& hinge,
                         std::span<const Vec3> points) {
  const Vec3 a = point_of(step, points, step.a), b = point_of(step, points, hinge.b);
  hinge.length = distance(a, b);
  hinge.spread = 0.0;
  const AxisBasis basis((1.0 / hinge.length) * (b - a));
  const auto members = forest_.set.at(step.unit);
  std::size_t place = 0;
  for (JointInUnit& joint : joints(step)) {  // in the order of the members
    while (members[place] != joint.joint) ++place;
    const HingePoint at = seen_from(basis, points[place] - a);
    joint.set_from_hinge(at);
    hinge.spread += joint.weight * (at.u * at.u + at.v * at.v);
  }
}

}  // namespace pliant
