// SPDX-License-Identifier: MIT
#include "pliant/resolve/froda/articulated_step.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "pliant/resolve/units/dense_solve.hpp"

namespace pliant {
namespace {

using froda::add_direction;
using froda::add_scaled;

constexpr double largest_turn = 0.5;  // radians
constexpr double damping = 10.0;
constexpr double tiny = 1e-30;
constexpr double redundant = 1e-9;
/// Each of the two directional masses of a row, so that their sum is above the row.
constexpr double majorant = 2.0;

Twist direction_of(const ContactRow& row, Vec3 x) {
  return twist_of(cross(x, row.along), row.along);
}

}  // namespace

ArticulatedStep::ArticulatedStep(const BodyPlan& plan, double unit)
    : plan_(plan),
      square_unit_(unit * unit),
      damping_(damping * square_unit_),
      inertia_(plan.bodies().size()),
      force_(plan.bodies().size()),
      twist_(plan.bodies().size()),
      turns_(plan.turn_count()),
      motion_(plan.bodies().size()) {}

void ArticulatedStep::step(std::span<Vec3> x, const StepRequest& request) {
  gather(x, request.targets);
  set_turns(x);
  const bool refined = request.conjugate_gradients > 0 && !request.rows.empty();
  if (refined) plain_ = inertia_;
  add_rows(x, request.rows, majorant);
  if (refined) left_ = force_;
  go_inward();
  go_outward(force_);
  if (refined) refine(x, request);
  if (!plan_.cuts().empty()) close_loops(x);
  move(x, share_of(x, request.bound));
}

void ArticulatedStep::gather(std::span<const Vec3> x, std::span<const Vec3> targets) {
  const auto bodies = plan_.bodies();
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    froda::PointSums sums;
    Vec3 pull, moment;
    for (Slot at = bodies[k].first; at < bodies[k].last; ++at) {
      sums.add(x[at]);
      if (targets.empty()) continue;
      const Vec3 force = targets[at] - x[at];
      pull += force;
      moment += cross(x[at], force);
    }
    inertia_[k] = sums.inertia();
    force_[k] = twist_of(moment, pull);
  }
}

void ArticulatedStep::set_turns(std::span<const Vec3> x) {
  constexpr std::array<Vec3, 3> axes{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  for (const PlanBody& body : plan_.bodies()) {
    const auto own = turns(body);
    if (own.size() == 1) {
      const Vec3 along = x[body.b] - x[body.a];
      const Vec3 axis = (1.0 / norm(along)) * along;
      own[0].s = twist_of(axis, cross(x[body.a], axis));
    } else {
      for (std::size_t t = 0; t < own.size(); ++t)
        own[t].s = twist_of(axes[t], cross(x[body.a], axes[t]));
    }
  }
}

void ArticulatedStep::add_rows(std::span<const Vec3> x, std::span<const ContactRow> rows,
                               double factor) {
  const auto body_at = plan_.body_at();
  for (const ContactRow& row : rows) {
    const std::uint32_t i = body_at[row.i], j = body_at[row.j];
    const Twist gi = direction_of(row, x[row.i]), gj = direction_of(row, x[row.j]);
    add_direction(factor * row.weight, gi, inertia_[i]);
    add_direction(factor * row.weight, gj, inertia_[j]);
    add_scaled(row.weight * row.gap, gi, force_[i]);
    add_scaled(-row.weight * row.gap, gj, force_[j]);
  }
}

void ArticulatedStep::go_inward() {
  const auto bodies = plan_.bodies();
  for (std::size_t k = bodies.size(); k-- > 0;)
    if (bodies[k].parent >= 0) pass_on(bodies[k], k);
}

/// Takes the turns of a body out of its inertia and force, and adds what is left to its parent's.
void ArticulatedStep::pass_on(const PlanBody& body, std::size_t index) {
  Inertia& m = inertia_[index];
  Twist& p = force_[index];
  const auto own = turns(body);
  for (std::size_t t = own.size(); t-- > 0;) {
    Turn& turn = own[t];
    turn.u = froda::product(m, turn.s);
    turn.inverse = 1.0 / (dot6(turn.s, turn.u) + damping_);
    turn.force = dot6(turn.s, p);
    add_scaled(-turn.force * turn.inverse, turn.u, p);
    add_direction(-turn.inverse, turn.u, m);
  }
  const auto parent = static_cast<std::size_t>(body.parent);
  for (std::size_t i = 0; i < 21; ++i) inertia_[parent][i] += m[i];
  for (std::size_t i = 0; i < 6; ++i) force_[parent][i] += p[i];
}

/// The same of forces alone, with the factors that go_inward() left.
void ArticulatedStep::push_inward(std::vector<Twist>& forces) {
  const auto bodies = plan_.bodies();
  for (std::size_t k = bodies.size(); k-- > 0;) {
    if (bodies[k].parent < 0) continue;
    const auto own = turns(bodies[k]);
    for (std::size_t t = own.size(); t-- > 0;) {
      own[t].force = dot6(own[t].s, forces[k]);
      add_scaled(-own[t].force * own[t].inverse, own[t].u, forces[k]);
    }
    add_scaled(1.0, forces[k], forces[std::size_t(bodies[k].parent)]);
  }
}

void ArticulatedStep::go_outward(const std::vector<Twist>& forces) {
  const auto bodies = plan_.bodies();
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    if (bodies[k].parent < 0) {
      twist_[k] = froda::solve6(inertia_[k], forces[k], square_unit_);
      continue;
    }
    Twist v = twist_[std::size_t(bodies[k].parent)];
    for (Turn& turn : turns(bodies[k])) {
      turn.angle = (turn.force - dot6(turn.u, v)) * turn.inverse;
      add_scaled(turn.angle, turn.s, v);
    }
    twist_[k] = v;
  }
}

/// Conjugate gradients for the rows as they are, preconditioned by the majorant; begins with its
/// step. Vectors over torsions are kept as twists and forces of bodies: q . f = sum v . p.
void ArticulatedStep::refine(std::span<const Vec3> x, const StepRequest& request) {
  const std::size_t bodies = inertia_.size();
  direction_ = twist_;
  direction_angle_.resize(turns_.size());
  for (std::size_t t = 0; t < turns_.size(); ++t) direction_angle_[t] = turns_[t].angle;
  sum_.assign(bodies, Twist{});
  sum_angle_.assign(turns_.size(), 0.0);
  const auto product = [&] {
    double sum = 0.0;
    for (std::size_t k = 0; k < bodies; ++k) sum += dot6(left_[k], twist_[k]);
    return sum;
  };
  double before = product();
  for (int turn = 0;; ++turn) {
    const double step = before / (apply_matrix(x, request.rows) + tiny);
    for (std::size_t k = 0; k < bodies; ++k) {
      add_scaled(step, direction_[k], sum_[k]);
      add_scaled(-step, image_[k], left_[k]);
    }
    for (std::size_t t = 0; t < turns_.size(); ++t) sum_angle_[t] += step * direction_angle_[t];
    if (turn + 1 >= request.conjugate_gradients) break;
    room_ = left_;
    push_inward(room_);
    go_outward(room_);
    const double now = product(), ratio = now / (before + tiny);
    before = now;
    for (std::size_t k = 0; k < bodies; ++k)
      for (std::size_t i = 0; i < 6; ++i)
        direction_[k][i] = twist_[k][i] + ratio * direction_[k][i];
    for (std::size_t t = 0; t < turns_.size(); ++t)
      direction_angle_[t] = turns_[t].angle + ratio * direction_angle_[t];
  }
  twist_ = sum_;
  for (std::size_t t = 0; t < turns_.size(); ++t) turns_[t].angle = sum_angle_[t];
}

/// What a unit force along a row moves: twists and angles, left in twist_ and turns_.
void ArticulatedStep::answer(const ContactRow& row, std::span<const Vec3> x) {
  const auto body_at = plan_.body_at();
  room_.assign(inertia_.size(), Twist{});
  add_scaled(1.0, direction_of(row, x[row.i]), room_[body_at[row.i]]);
  add_scaled(-1.0, direction_of(row, x[row.j]), room_[body_at[row.j]]);
  push_inward(room_);
  go_outward(room_);
}

void ArticulatedStep::close_loops(std::span<const Vec3> x) {
  constexpr std::array<Vec3, 3> axes{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  const auto body_at = plan_.body_at();
  cut_rows_.clear();
  for (const LoopCut& cut : plan_.cuts())
    for (Vec3 axis : axes)
      cut_rows_.push_back({cut.copy, cut.joint, axis, dot(axis, x[cut.joint] - x[cut.copy]), 1.0});
  const std::size_t count = cut_rows_.size();
  answer_.resize(count + 1);
  answer_angle_.resize(count + 1);
  products_.assign(count * count, 0.0);
  factors_.resize(count);
  for (std::size_t r = 0; r <= count; ++r) {
    if (r > 0) answer(cut_rows_[r - 1], x);
    answer_[r] = twist_;
    answer_angle_[r].resize(turns_.size());
    for (std::size_t t = 0; t < turns_.size(); ++t) answer_angle_[r][t] = turns_[t].angle;
  }
  double trace = 0.0;
  for (std::size_t r = 0; r < count; ++r) {
    const ContactRow& row = cut_rows_[r];
    const auto apart = [&](std::size_t of) {
      return dot(row.along, froda::velocity(answer_[of][body_at[row.i]], x[row.i]) -
                                froda::velocity(answer_[of][body_at[row.j]], x[row.j]));
    };
    factors_[r] = apart(0) - row.gap;
    for (std::size_t k = 0; k < count; ++k) products_[r * count + k] = apart(k + 1);
    trace += products_[r * count + r];
  }
  // Two joints of one cut keep their distance, so that one of their six rows says nothing new.
  for (std::size_t r = 0; r < count; ++r)
    products_[r * count + r] += redundant * trace / double(count);
  if (!solve_positive(products_, factors_, 0.0)) std::fill(factors_.begin(), factors_.end(), 0.0);
  twist_ = answer_[0];
  for (std::size_t t = 0; t < turns_.size(); ++t) turns_[t].angle = answer_angle_[0][t];
  for (std::size_t r = 0; r < count; ++r) {
    for (std::size_t k = 0; k < twist_.size(); ++k)
      add_scaled(-factors_[r], answer_[r + 1][k], twist_[k]);
    for (std::size_t t = 0; t < turns_.size(); ++t)
      turns_[t].angle -= factors_[r] * answer_angle_[r + 1][t];
  }
}

/// image_ = (H + sum w g g^T) direction_; the product of both.
double ArticulatedStep::apply_matrix(std::span<const Vec3> x, std::span<const ContactRow> rows) {
  const auto body_at = plan_.body_at();
  image_.resize(plain_.size());
  double sum = 0.0;
  for (std::size_t k = 0; k < plain_.size(); ++k) {
    image_[k] = froda::product(plain_[k], direction_[k]);
    sum += dot6(image_[k], direction_[k]);
  }
  for (double angle : direction_angle_) sum += damping_ * angle * angle;
  for (const ContactRow& row : rows) {
    const std::uint32_t i = body_at[row.i], j = body_at[row.j];
    const double apart = dot(row.along, froda::velocity(direction_[i], x[row.i]) -
                                            froda::velocity(direction_[j], x[row.j]));
    const double force = row.weight * apart;
    sum += force * apart;
    add_scaled(force, direction_of(row, x[row.i]), image_[i]);
    add_scaled(-force, direction_of(row, x[row.j]), image_[j]);
  }
  return sum;
}

/// How much of the step leaves each body within the bound and each turn below half a radian.
double ArticulatedStep::share_of(std::span<const Vec3> x, double bound) const {
  double furthest = 0.0, widest = 0.0;
  const auto bodies = plan_.bodies();
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    if (bodies[k].first == bodies[k].last) continue;
    for (Slot at : {bodies[k].first, bodies[k].last - 1})
      furthest = std::max(furthest, norm_squared(froda::velocity(twist_[k], x[at])));
    if (bodies[k].parent < 0) widest = std::max(widest, norm_squared(upper_of(twist_[k])));
  }
  for (const Turn& turn : turns_) widest = std::max(widest, turn.angle * turn.angle);
  double share = 1.0;
  if (furthest > bound * bound) share = bound / std::sqrt(furthest);
  if (widest > largest_turn * largest_turn)
    share = std::min(share, largest_turn / std::sqrt(widest));
  return share;
}

void ArticulatedStep::move(std::span<Vec3> x, double share) {
  const auto bodies = plan_.bodies();
  for (std::size_t k = 0; k < bodies.size(); ++k) motion_[k] = motion_of(bodies[k], k, x, share);
  for (std::size_t k = 0; k < bodies.size(); ++k)
    for (Slot at = bodies[k].first; at < bodies[k].last; ++at) x[at] = motion_[k](x[at]);
}

/// Turns by Cayley's formula, without trigonometry; a hinge stays where the parent takes it.
ArticulatedStep::Motion ArticulatedStep::motion_of(const PlanBody& body, std::size_t index,
                                                   std::span<const Vec3> x, double share) const {
  Vec3 h;
  if (body.parent < 0) {
    h = (0.5 * share) * upper_of(twist_[index]);
  } else {
    for (std::uint32_t t = 0; t < body.turns(); ++t) {
      const Turn& turn = turns_[body.first_turn + t];
      h += (0.5 * share * turn.angle) * upper_of(turn.s);
    }
  }
  const Vec3 g = (2.0 / (1.0 + norm_squared(h))) * h;
  const Vec3 rx{1.0 - (h.y * g.y + h.z * g.z), h.x * g.y - g.z, h.x * g.z + g.y};
  const Vec3 ry{h.x * g.y + g.z, 1.0 - (h.x * g.x + h.z * g.z), h.y * g.z - g.x};
  const Vec3 rz{h.x * g.z - g.y, h.y * g.z + g.x, 1.0 - (h.x * g.x + h.y * g.y)};
  if (body.parent < 0) return {rx, ry, rz, share * lower_of(twist_[index])};
  const Motion& carried = motion_[std::size_t(body.parent)];
  const Vec3 through = x[body.a];
  const Vec3 turned{dot(rx, through), dot(ry, through), dot(rz, through)};
  const auto row = [&](Vec3 a) { return a.x * rx + a.y * ry + a.z * rz; };
  return {row(carried.rx), row(carried.ry), row(carried.rz), carried(through - turned)};
}

}  // namespace pliant
