// SPDX-License-Identifier: MIT
#include "pliant/resolve/bodies/outward/loop_closure.hpp"

#include <algorithm>
#include <cmath>

#include "pliant/base/math/dense_solve.hpp"
#include "pliant/rigidity/place_unit.hpp"

namespace pliant {
namespace {

constexpr std::size_t most_gaps = 60;
constexpr std::size_t most_turns = 4000;
constexpr int most_steps = 60;
constexpr int most_halvings = 8;
/// Largest turn of one step (radians): beyond it first order says little.
constexpr double largest_turn = 0.5;
/// Least pivot, relative to its diagonal, of loops that torsions can close: flat rings, all of
/// whose hinges lie in one plane, are beyond it.
constexpr double least_pivot = 1e-7;

}  // namespace

std::optional<LoopClosure> LoopClosure::make(const UnitSet& set, const UnitShapes& shapes,
                                             const UnitGraph& graph) {
  LoopClosure made;
  std::vector<std::int32_t> body_of(set.size(), -1), owner_of(graph.connections.size(), -1);
  std::vector<std::uint32_t> waiting{0};
  body_of[0] = 0;
  made.add_unit(set, shapes, 0);
  for (std::size_t next = 0; next < waiting.size(); ++next)
    for (const Link& link : graph.links.at(waiting[next])) {
      std::int32_t& owner = owner_of[link.node - graph.units];
      if (owner >= 0) continue;
      owner = static_cast<std::int32_t>(next);
      const UnitConnection& at = graph.connection(link.node);
      for (const Link& to : graph.links.at(link.node)) {
        if (to.node == waiting[next]) continue;
        if (body_of[to.node] >= 0) {
          made.add_gaps(std::size_t(body_of[to.node]), next, at);
          continue;
        }
        body_of[to.node] = static_cast<std::int32_t>(made.units_.size());
        waiting.push_back(to.node);
        made.add_unit(set, shapes, to.node);
        made.hang(made.units_.size() - 1, next, at);
      }
    }
  if (waiting.size() < set.size() || made.gaps_.size() > most_gaps ||
      made.turns_.size() > most_turns)
    return std::nullopt;
  made.places_ = made.targets_ = made.kept_ = made.shape_;
  made.motions_.resize(made.units_.size());
  made.way_.resize(made.units_.size());
  made.residual_.resize(made.equations_);
  made.jacobian_.resize(made.residual_.size() * made.turns_.size());
  made.matrix_.resize(made.residual_.size() * made.residual_.size());
  made.rows_of_turn_.resize(made.turns_.size());
  made.step_.resize(made.turns_.size());
  return made;
}

void LoopClosure::add_unit(const UnitSet& set, const UnitShapes& shapes, std::uint32_t index) {
  LoopUnit unit;
  unit.first = static_cast<std::uint32_t>(joints_.size());
  unit.count = static_cast<std::uint32_t>(set.at(index).size());
  unit.mirror_allowed = shapes.kinds[index] == ShapeKind::lengths;
  joints_.insert(joints_.end(), set.at(index).begin(), set.at(index).end());
  for (std::size_t k = set.begin_of(index); k < set.begin_of(index + 1); ++k)
    shape_.push_back(shapes.points[k]);
  units_.push_back(unit);
}

std::uint32_t LoopClosure::copy_of(std::size_t unit, Joint joint) const {
  const auto first = joints_.begin() + units_[unit].first;
  return static_cast<std::uint32_t>(std::lower_bound(first, first + units_[unit].count, joint) -
                                    joints_.begin());
}

void LoopClosure::hang(std::size_t index, std::size_t parent, const UnitConnection& at) {
  LoopUnit& unit = units_[index];
  unit.parent = static_cast<std::int32_t>(parent);
  unit.a = copy_of(parent, at.a);
  unit.b = copy_of(parent, at.b);
  unit.own_a = copy_of(index, at.a);
  unit.own_b = copy_of(index, at.b);
  unit.first_turn = static_cast<std::uint32_t>(turns_.size());
  unit.turns = static_cast<std::uint32_t>(at.freedom());
  turns_.resize(turns_.size() + unit.turns);
}

void LoopClosure::add_gaps(std::size_t unit, std::size_t owner, const UnitConnection& at) {
  const auto add_gap = [&](Joint joint, std::optional<std::uint32_t> first_of_hinge) {
    gaps_.push_back({copy_of(unit, joint), copy_of(owner, joint), static_cast<std::int32_t>(unit),
                     static_cast<std::int32_t>(owner), equations_, first_of_hinge});
    equations_ += first_of_hinge ? 2 : 3;
  };
  add_gap(at.a, {});
  if (at.is_hinge()) add_gap(at.b, copy_of(owner, at.a));
}

void LoopClosure::place_all(std::span<const Vec3> positions, Vec3 origin) {
  for (std::size_t k = 0; k < joints_.size(); ++k) targets_[k] = positions[joints_[k]] - origin;
  for (const LoopUnit& unit : units_) {
    if (unit.turns == 1) {
      place_by_torsion(unit);
    } else {
      place_by_rotation(unit);
    }
  }
}

/// About the shared joint, or about the centroid of the first unit.
void LoopClosure::place_by_rotation(const LoopUnit& unit) {
  Vec3 middle, goal;
  for (std::size_t k = unit.first; k < unit.first + unit.count; ++k) {
    middle += (1.0 / unit.count) * shape_[k];
    goal += (1.0 / unit.count) * targets_[k];
  }
  if (unit.parent >= 0) {
    middle = shape_[unit.own_a];
    goal = places_[unit.a];
  }
  TurnAboutPoint turned(goal);
  for (std::size_t k = unit.first; k < unit.first + unit.count; ++k)
    turned.add(shape_[k] - middle, targets_[k], 1.0);
  turned.fit(unit.mirror_allowed);
  for (std::size_t k = unit.first; k < unit.first + unit.count; ++k)
    places_[k] = turned(shape_[k] - middle);
}

void LoopClosure::place_by_torsion(const LoopUnit& unit) {
  const auto basis_of = [](Vec3 axis) { return AxisBasis((1.0 / norm(axis)) * axis); };
  const Vec3 from = shape_[unit.own_a], to = places_[unit.a];
  const AxisBasis own = basis_of(shape_[unit.own_b] - from);
  TurnAboutHinge turned(to, basis_of(places_[unit.b] - to));
  for (std::size_t k = unit.first; k < unit.first + unit.count; ++k)
    turned.add(seen_from(own, shape_[k] - from), targets_[k], 1.0);
  TorsionFit::Turn turn = turned.best(unit.mirror_allowed);
  if (!(turn.strength > 0.0)) turn = {};
  turned.turn_by(turn);
  for (std::size_t k = unit.first; k < unit.first + unit.count; ++k)
    places_[k] = turned(seen_from(own, shape_[k] - from));
}

double LoopClosure::measure_gaps() {
  double widest = 0.0;
  for (const Gap& gap : gaps_) {
    const double width = distance(places_[gap.one], places_[gap.other]);
    if (!(width <= widest)) widest = width;
  }
  return widest;
}

void LoopClosure::find_turns() {
  constexpr Vec3 axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const LoopUnit& unit : units_) {
    const Vec3 through = unit.parent >= 0 ? places_[unit.a] : Vec3{};
    for (std::uint32_t k = 0; k < unit.turns; ++k) turns_[unit.first_turn + k] = {axes[k], through};
    if (unit.turns != 1) continue;
    const Vec3 along = places_[unit.b] - through;
    turns_[unit.first_turn].axis = (1.0 / norm(along)) * along;
  }
}

/// The second joint of a hinge is at its distance from the first already: it meets its copy if it
/// does so at right angles to the hinge.
void LoopClosure::set_directions(const Gap& gap) {
  directions_ = {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  if (!gap.first_of_hinge) return;
  const Vec3 along = places_[gap.other] - places_[*gap.first_of_hinge];
  const AxisBasis basis((1.0 / norm(along)) * along);
  directions_ = {basis.e1, basis.e2, Vec3{}};
}

void LoopClosure::mark_ways(const Gap& gap) {
  std::fill(way_.begin(), way_.end(), Way::neither);
  for (std::int32_t k = gap.unit; k >= 0; k = units_[std::size_t(k)].parent)
    way_[std::size_t(k)] = Way::one;
  for (std::int32_t k = gap.other_unit; k >= 0; k = units_[std::size_t(k)].parent) {
    Way& way = way_[std::size_t(k)];
    way = way == Way::one ? Way::both : Way::other;
  }
}

/// The rows of one gap: turns on the way to one copy only. What turns both changes nothing.
void LoopClosure::fill_rows(const Gap& gap) {
  set_directions(gap);
  const Vec3 r = places_[gap.one] - places_[gap.other];
  for (std::size_t i = 0; i < gap.equations(); ++i)
    residual_[gap.first + i] = dot(directions_[i], r);
  mark_ways(gap);
  fill_way(gap, Way::one);
  fill_way(gap, Way::other);
}

void LoopClosure::fill_way(const Gap& gap, Way way) {
  const bool is_one = way == Way::one;
  const double sign = is_one ? 1.0 : -1.0;
  const Vec3 point = places_[is_one ? gap.one : gap.other];
  const std::size_t n = turns_.size();
  for (std::int32_t k = is_one ? gap.unit : gap.other_unit; k >= 0;
       k = units_[std::size_t(k)].parent) {
    const LoopUnit& unit = units_[std::size_t(k)];
    if (way_[std::size_t(k)] != way) continue;
    for (std::uint32_t t = unit.first_turn; t < unit.first_turn + unit.turns; ++t) {
      const Vec3 d = sign * cross(turns_[t].axis, point - turns_[t].through);
      for (std::uint32_t i = 0; i < gap.equations(); ++i) {
        jacobian_[(gap.first + i) * n + t] = dot(directions_[i], d);
        rows_of_turn_[t].push_back(gap.first + i);
      }
    }
  }
}

void LoopClosure::fill_jacobian() {
  const std::size_t n = turns_.size();
  for (std::size_t t = 0; t < n; ++t) {
    for (std::uint32_t row : rows_of_turn_[t]) jacobian_[row * n + t] = 0.0;
    rows_of_turn_[t].clear();
  }
  for (const Gap& gap : gaps_) fill_rows(gap);
}

/// J J^T, its lower half. Most turns are on the way to few gaps.
void LoopClosure::fill_matrix() {
  const std::size_t m = residual_.size(), n = turns_.size();
  std::fill(matrix_.begin(), matrix_.end(), 0.0);
  for (std::size_t t = 0; t < n; ++t)
    for (std::uint32_t i : rows_of_turn_[t])
      for (std::uint32_t j : rows_of_turn_[t])
        if (j <= i) matrix_[i * m + j] += jacobian_[i * n + t] * jacobian_[j * n + t];
}

bool LoopClosure::solve_step() {
  find_turns();
  fill_jacobian();
  fill_matrix();
  if (!solve_positive(matrix_, residual_, least_pivot)) return false;
  double largest = 0.0;
  const std::size_t n = turns_.size();
  for (std::size_t k = 0; k < n; ++k) {
    step_[k] = 0.0;
    for (std::uint32_t i : rows_of_turn_[k]) step_[k] -= jacobian_[i * n + k] * residual_[i];
  }
  for (const LoopUnit& unit : units_) largest = std::max(largest, norm(turn_vector(unit)));
  if (largest > largest_turn)
    for (double& turn : step_) turn *= largest_turn / largest;
  return std::isfinite(largest);
}

/// Axis times angle of the turns of a unit together (radians).
Vec3 LoopClosure::turn_vector(const LoopUnit& unit) const {
  Vec3 sum;
  for (std::uint32_t t = unit.first_turn; t < unit.first_turn + unit.turns; ++t)
    sum += step_[t] * turns_[t].axis;
  return sum;
}

/// Turns every unit about the hinges on its way from the first, innermost last.
void LoopClosure::apply(double share) {
  for (std::size_t k = 0; k < units_.size(); ++k) {
    const LoopUnit& unit = units_[k];
    RigidMotion& motion = motions_[k];
    motion = unit.parent >= 0 ? motions_[std::size_t(unit.parent)] : RigidMotion{};
    const Vec3 vector = turn_vector(unit);
    const double angle = norm(vector);
    if (angle > 0.0) {
      const Rotation turn = turn_about((1.0 / angle) * vector, 0.5 * share * angle);
      motion = motion.after(turn, turns_[unit.first_turn].through);
    }
    for (std::size_t j = unit.first; j < unit.first + unit.count; ++j)
      places_[j] = motion(kept_[j]);
  }
}

bool LoopClosure::close(std::span<Vec3> positions, double gap) {
  const Vec3 origin = positions[joints_[0]];
  place_all(positions, origin);
  double width = measure_gaps();
  for (int step = 0; step < most_steps && width > gap; ++step) {
    keep();
    if (!std::isfinite(width) || !solve_step()) return false;
    double share = 1.0, now = width;
    for (int halving = 0; halving <= most_halvings; ++halving, share *= 0.5) {
      apply(share);
      now = measure_gaps();
      if (now < width) break;
    }
    if (!(now < width)) return false;
    width = now;
  }
  if (!(width <= gap)) return false;
  for (std::size_t k = joints_.size(); k-- > 0;) positions[joints_[k]] = origin + places_[k];
  return true;
}

}  // namespace pliant
