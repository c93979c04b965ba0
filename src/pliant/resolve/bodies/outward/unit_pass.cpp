// SPDX-License-Identifier: MIT
#include "pliant/resolve/bodies/outward/unit_pass.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "pliant/resolve/method/project_bar.hpp"

namespace pliant {
namespace {

/// Relative error of a hinge that counts as wrong: pinned joints may hold one apart.
constexpr double most_hinge_error = 1e-6;
/// Below this share of what its joints could give, the direction of a torsion is rounding.
constexpr double weakest_turn = 1e-13;
/// A unit whose joints are this close to its hinge, in lengths of the hinge, has no torsion.
constexpr double thinnest_unit = 1e-10;

UnitPass::Placement worse(UnitPass::Placement one, UnitPass::Placement other) {
  using enum UnitPass::Placement;
  if (one == not_finite || other == not_finite) return not_finite;
  return one == unfit || other == unfit ? unfit : placed;
}

RandomSequence escape_draws(RandomKey key, Joint joint) {
  key.domain = Domain::escape;
  key.joint = joint;
  return RandomSequence(key);
}

}  // namespace

UnitPass::UnitPass(const Framework& framework, UnitSet units, const Technique& technique,
                   const ResolveOptions& options)
    : framework_(framework),
      forest_(find_unit_forest(framework, std::move(units), options.tolerance)),
      plan_(framework, forest_, technique.mass_weighted) {
  if (!forest_.has_unknown()) return;
  make_loops(technique, options);
  close_by_torsions(options);
  forest_.rigid = {};
  forest_.of_rigid = {};
}

void UnitPass::make_loops(const Technique& technique, const ResolveOptions& options) {
  const UnitsOfJoints units(forest_.set, framework_.joint_count());
  std::vector<std::pair<std::uint32_t, BarIndex>> bars;  // of units without a shape
  std::vector<std::uint32_t> both;
  for (std::size_t k = 0; k < framework_.bar_count(); ++k) {
    units.common(framework_.bars()[k].a, framework_.bars()[k].b, both);
    for (std::uint32_t unit : both)
      if (forest_.shapes.kinds[unit] == ShapeKind::unknown)
        bars.emplace_back(unit, static_cast<BarIndex>(k));
  }
  std::sort(bars.begin(), bars.end());
  std::vector<BarIndex> own;
  for (std::size_t k = 0; k < bars.size(); ++k) {
    own.push_back(bars[k].second);
    if (k + 1 < bars.size() && bars[k + 1].first == bars[k].first) continue;
    make_loop(bars[k].first, own, technique, options);
    own.clear();
  }
}

void UnitPass::make_loop(std::uint32_t unit, std::span<const BarIndex> bars,
                         const Technique& technique, const ResolveOptions& options) {
  loops_.push_back(
      std::make_unique<UnitLoop>(framework_, forest_.set.at(unit), bars, technique, options));
  loop_of_.resize(unit + 1, nullptr);
  loop_of_[unit] = loops_.back().get();
}

/// Gives each loop the rigid units that it is made of.
void UnitPass::close_by_torsions(const ResolveOptions& options) {
  struct Parts {
    UnitSet rigid;
    UnitShapes shapes;
  };
  std::map<std::uint32_t, Parts> parts_of;
  const UnitShapes shapes = find_unit_shapes(framework_, forest_.rigid, options.tolerance);
  std::vector<Vec3> room;
  for (std::uint32_t k = 0; k < forest_.rigid.size(); ++k) {
    const std::uint32_t unit = forest_.of_rigid[k];
    if (unit >= loop_of_.size() || loop_of_[unit] == nullptr) continue;
    Parts& parts = parts_of[unit];
    parts.rigid.add(forest_.rigid.at(k));
    parts.shapes.kinds.push_back(shapes.kinds[k]);
    const auto points = points_of(framework_, forest_.rigid, shapes, k, room);
    parts.shapes.points.insert(parts.shapes.points.end(), points.begin(), points.end());
  }
  for (auto& [unit, parts] : parts_of)
    loop_of_[unit]->close_by_torsions(std::move(parts.rigid), parts.shapes);
}

UnitPass::Placement UnitPass::run(const ResolveCall& call) {
  planned_.prepare(call.disturbed.root, [this](Joint root) { plan_.plan(root); });
  Placement worst = Placement::placed;
  for (auto& loop : loops_)
    if (!loop->find_shape(call)) worst = Placement::unfit;
  for (UnitStep& step : plan_.steps()) {
    if (step.is<UnitStep::Still>()) place_still(call, step);
    worst = worse(worst, place(call, step));
  }
  return worst;
}

UnitPass::Placement UnitPass::look_ahead(const ResolveCall& call, std::span<const Vec3> targets) {
  for (UnitStep& step : plan_.steps()) {
    if (!step.is_known) plan_.set_shape(step, loop_of_[step.unit]->shape());
    if (step.is<UnitStep::Still>()) place_still(call, step);
  }
  return ahead_.place(plan_, call.positions, targets) ? Placement::placed : Placement::unfit;
}

UnitPass::Placement UnitPass::place(const ResolveCall& call, UnitStep& step) {
  if (!step.is_known && !step.is<UnitStep::Still>())
    plan_.set_shape(step, loop_of_[step.unit]->shape());
  return std::visit([&](const auto& entry) { return place_by(entry, call, step); }, step.entry);
}

void UnitPass::place_still(const ResolveCall& call, const UnitStep& step) const {
  const auto joints = forest_.set.at(step.unit);
  const auto shape = loop_of_[step.unit]->shape();
  for (std::size_t k = 0; k < joints.size(); ++k) call.positions[joints[k]] = shape[k];
}

/// In run() it was placed already.
UnitPass::Placement UnitPass::place_by(const UnitStep::Still&, const ResolveCall&,
                                       const UnitStep&) {
  return Placement::placed;
}

UnitPass::Placement UnitPass::place_by(const UnitStep::Rod& rod, const ResolveCall& call,
                                       const UnitStep& step) {
  if (framework_.is_pinned(rod.b)) return Placement::placed;
  carry_far(call.positions[step.a], call.positions[rod.b], rod.length,
            [&] { return framework_.random_direction(escape_draws(call.key, rod.b)); });
  return Placement::placed;
}

UnitPass::Placement UnitPass::place_by(const UnitStep::Free&, const ResolveCall& call,
                                       const UnitStep& step) {
  double sum = 0.0;
  Vec3 centroid;
  for (const JointInUnit& joint : plan_.joints(step)) {
    centroid += joint.weight * call.positions[joint.joint];
    sum += joint.weight;
  }
  centroid *= 1.0 / sum;
  return place_about(centroid, call.positions, step);
}

UnitPass::Placement UnitPass::place_by(const UnitStep::Ball&, const ResolveCall& call,
                                       const UnitStep& step) {
  return place_about(call.positions[step.a], call.positions, step);
}

UnitPass::Placement UnitPass::place_about(Vec3 point, std::span<Vec3> positions,
                                          const UnitStep& step) {
  const auto joints = plan_.joints(step);
  TurnAboutPoint turned(point);
  for (const JointInUnit& joint : joints)
    turned.add(joint.from_point(), positions[joint.joint], joint.weight);
  const RotationFit::Fit fit = turned.fit(step.mirror_allowed);
  if (fit == RotationFit::Fit::not_finite) return Placement::not_finite;
  if (fit == RotationFit::Fit::undefined) return Placement::unfit;
  for (const JointInUnit& joint : joints) positions[joint.joint] = turned(joint.from_point());
  return Placement::placed;
}

UnitPass::Placement UnitPass::place_by(const UnitStep::Hinge& hinge, const ResolveCall& call,
                                       const UnitStep& step) {
  const std::span<Vec3> x = call.positions;
  const Vec3 a = x[step.a], along = x[hinge.b] - a;
  const double length = norm(along);
  if (!std::isfinite(length)) return Placement::not_finite;
  if (!(std::abs(length - hinge.length) <= most_hinge_error * hinge.length))
    return Placement::unfit;
  TurnAboutHinge turned(a, AxisBasis((1.0 / length) * along));
  const auto joints = plan_.joints(step);
  for (const JointInUnit& joint : joints)
    turned.add(joint.from_hinge(), x[joint.joint], joint.weight);
  TorsionFit::Turn turn = turned.best(step.mirror_allowed);
  if (std::isnan(turn.strength)) return Placement::not_finite;
  if (!(turn.strength > weakest_turn * hinge.spread)) {
    turn = any_turn(call.key, hinge, length);
  } else if (!std::isfinite(turn.strength)) {
    return Placement::not_finite;
  }
  turned.turn_by(turn);
  for (const JointInUnit& joint : joints) x[joint.joint] = turned(joint.from_hinge());
  return Placement::placed;
}

/// What the seed decides; none where the unit has no torsion.
TorsionFit::Turn UnitPass::any_turn(RandomKey key, const UnitStep::Hinge& hinge,
                                    double length) const {
  TorsionFit::Turn turn;
  if (!(hinge.spread > thinnest_unit * thinnest_unit * length * length)) return turn;
  const AxisBasis any(framework_.random_direction(escape_draws(key, hinge.b)));
  const double size = std::sqrt(any.e1.x * any.e1.x + any.e1.y * any.e1.y);
  if (size > 0.0) {
    turn.cosine = any.e1.x / size;
    turn.sine = any.e1.y / size;
  }
  return turn;
}

}  // namespace pliant
