// SPDX-License-Identifier: MIT
#include "pliant/resolve/bodies/tree/articulated_step.hpp"

#include <algorithm>
#include <cmath>

namespace pliant {

using froda::damping, froda::largest_turn, froda::majorant, froda::tiny;

namespace {

/// y += factor x.
void add_motions(double factor, const BodyMotions& x, BodyMotions& y) {
  for (std::size_t k = 0; k < x.twists.size(); ++k)
    froda::add_scaled(factor, x.twists[k], y.twists[k]);
  for (std::size_t t = 0; t < x.angles.size(); ++t) y.angles[t] += factor * x.angles[t];
}

/// y = x + factor y.
void add_to_scaled(const BodyMotions& x, double factor, BodyMotions& y) {
  for (std::size_t k = 0; k < x.twists.size(); ++k)
    for (std::size_t i = 0; i < 6; ++i) y.twists[k][i] = x.twists[k][i] + factor * y.twists[k][i];
  for (std::size_t t = 0; t < x.angles.size(); ++t)
    y.angles[t] = x.angles[t] + factor * y.angles[t];
}

double product(const std::vector<Twist>& forces, const std::vector<double>& of_turns,
               const BodyMotions& motions) {
  double sum = 0.0;
  for (std::size_t k = 0; k < forces.size(); ++k) sum += froda::dot(forces[k], motions.twists[k]);
  for (std::size_t t = 0; t < of_turns.size(); ++t) sum += of_turns[t] * motions.angles[t];
  return sum;
}

}  // namespace

ArticulatedStep::ArticulatedStep(const BodyPlan& plan, const WorkingTrees& working, double unit)
    : plan_(plan), working_(working), pass_(plan, working, damping * unit * unit, unit * unit) {
  fit();
}

void ArticulatedStep::fit() {
  pass_.fit();
  if (!closing_ && !plan_.cuts().empty()) closing_ = std::make_unique<CutClosing>(plan_, working_);
  motions_.twists.resize(plan_.bodies().size());
  motions_.angles.resize(plan_.turn_count());
  motion_.resize(plan_.bodies().size());
}

double ArticulatedStep::step(std::span<Vec3> x, const StepRequest& request) {
  pass_.gather(x, request.targets);
  const bool refined = request.conjugate_gradients > 0 && !request.rows.empty();
  pass_.add_pulls(x, request.pulls);
  pass_.add_rows(x, request.rows, majorant);
  if (refined) left_ = pass_.forces();
  pass_.go_inward(request.springs);
  pass_.go_outward(pass_.forces(), motions_);
  if (refined) refine(x, request);
  if (closing_) closing_->correct(pass_, x, motions_);
  const Share share = share_of(x, request.bound);
  move(x, share.of_step);
  return share.furthest;
}

/// Conjugate gradients for the rows as they are, preconditioned by the majorant; begins with its
/// step. Vectors over torsions are kept as twists and forces of bodies, with what is of turns alone
/// beside them: q . f = sum v . p + sum q tau.
void ArticulatedStep::refine(std::span<const Vec3> x, const StepRequest& request) {
  direction_ = motions_;
  sum_.twists.assign(motions_.twists.size(), Twist{});
  sum_.angles.assign(motions_.angles.size(), 0.0);
  left_of_turns_.assign(motions_.angles.size(), 0.0);
  for (std::size_t t = 0; t < request.springs.size(); ++t)
    left_of_turns_[t] = request.springs[t].force;
  double before = product(left_, left_of_turns_, motions_);
  for (int turn = 0;; ++turn) {
    const double step = before / (apply_matrix(x, request) + tiny);
    add_motions(step, direction_, sum_);
    if (turn + 1 >= request.conjugate_gradients) break;
    for (std::size_t k = 0; k < left_.size(); ++k) froda::add_scaled(-step, image_[k], left_[k]);
    for (std::size_t t = 0; t < left_of_turns_.size(); ++t)
      left_of_turns_[t] -= step * resistance(request, t) * direction_.angles[t];
    room_ = left_;
    pass_.push_inward(room_, left_of_turns_);
    pass_.go_outward(room_, motions_);
    const double now = product(left_, left_of_turns_, motions_), ratio = now / (before + tiny);
    before = now;
    add_to_scaled(motions_, ratio, direction_);
  }
  motions_ = sum_;
}

/// How much a turn resists by itself: damping and springs.
double ArticulatedStep::resistance(const StepRequest& request, std::size_t turn) const {
  return pass_.damping() + (request.springs.empty() ? 0.0 : request.springs[turn].weight);
}

/// image_ = (H + sum w g g^T) direction_ but for what turns resist by themselves; the product of
/// both with it.
double ArticulatedStep::apply_matrix(std::span<const Vec3> x, const StepRequest& request) {
  const auto bodies = plan_.bodies();
  image_.resize(bodies.size());
  double sum = 0.0;
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    image_[k] = pull_of(bodies[k], direction_.twists[k], x);
    sum += froda::dot(image_[k], direction_.twists[k]);
  }
  for (std::size_t t = 0; t < direction_.angles.size(); ++t)
    sum += resistance(request, t) * direction_.angles[t] * direction_.angles[t];
  for (const DistanceRow& row : request.rows) sum += add_row(row, x);
  return sum;
}

/// The inertia of a body times a twist, joint by joint: few hang on one body.
Twist ArticulatedStep::pull_of(const PlanBody& body, const Twist& twist, std::span<const Vec3> x) {
  Vec3 pull, moment;
  for (Slot at = body.first; at < body.last; ++at) {
    const Vec3 v = froda::velocity(twist, x[at]);
    pull += v;
    moment += cross(x[at], v);
  }
  return twist_of(moment, pull);
}

/// w g g^T direction_, to image_; its product with direction_.
double ArticulatedStep::add_row(const DistanceRow& row, std::span<const Vec3> x) {
  const auto body_at = plan_.body_at();
  const std::uint32_t i = body_at[row.i], j = body_at[row.j];
  const double apart = dot(row.along, froda::velocity(direction_.twists[i], x[row.i]) -
                                          froda::velocity(direction_.twists[j], x[row.j]));
  const double force = row.weight * apart;
  froda::add_scaled(force, row.direction(x[row.i]), image_[i]);
  froda::add_scaled(-force, row.direction(x[row.j]), image_[j]);
  return force * apart;
}

/// How much of the step leaves each body within the bound and each turn below half a radian.
ArticulatedStep::Share ArticulatedStep::share_of(std::span<const Vec3> x, double bound) const {
  double furthest = 0.0, widest = 0.0;
  const auto bodies = plan_.bodies();
  for (const std::uint32_t k : working_.bodies()) {
    if (bodies[k].parent < 0) widest = std::max(widest, norm_squared(upper_of(motions_.twists[k])));
    for (std::uint32_t t = 0; t < bodies[k].turns(); ++t) {
      const double angle = motions_.angles[bodies[k].first_turn + t];
      widest = std::max(widest, angle * angle);
    }
    if (bodies[k].first == bodies[k].last) continue;
    for (Slot at : {bodies[k].first, bodies[k].last - 1})
      furthest = std::max(furthest, norm_squared(froda::velocity(motions_.twists[k], x[at])));
  }
  double share = 1.0;
  if (furthest > bound * bound) share = bound / std::sqrt(furthest);
  if (widest > largest_turn * largest_turn)
    share = std::min(share, largest_turn / std::sqrt(widest));
  return {share, share * std::sqrt(furthest)};
}

void ArticulatedStep::move(std::span<Vec3> x, double share) {
  const auto bodies = plan_.bodies();
  for (const std::uint32_t k : working_.bodies()) motion_[k] = motion_of(bodies[k], k, x, share);
  for (const std::uint32_t k : working_.bodies())
    for (Slot at = bodies[k].first; at < bodies[k].last; ++at) x[at] = motion_[k](x[at]);
}

/// Turns by Cayley's formula, without trigonometry; a hinge stays where the parent takes it.
ArticulatedStep::Motion ArticulatedStep::motion_of(const PlanBody& body, std::size_t index,
                                                   std::span<const Vec3> x, double share) const {
  Vec3 h;
  if (body.parent < 0) {
    h = (0.5 * share) * upper_of(motions_.twists[index]);
  } else {
    for (std::uint32_t t = 0; t < body.turns(); ++t) {
      const std::uint32_t turn = body.first_turn + t;
      h += (0.5 * share * motions_.angles[turn]) * upper_of(pass_.turns()[turn].s);
    }
  }
  const Vec3 g = (2.0 / (1.0 + norm_squared(h))) * h;
  const Vec3 rx{1.0 - (h.y * g.y + h.z * g.z), h.x * g.y - g.z, h.x * g.z + g.y};
  const Vec3 ry{h.x * g.y + g.z, 1.0 - (h.x * g.x + h.z * g.z), h.y * g.z - g.x};
  const Vec3 rz{h.x * g.z - g.y, h.y * g.z + g.x, 1.0 - (h.x * g.x + h.y * g.y)};
  if (body.parent < 0) return {rx, ry, rz, share * lower_of(motions_.twists[index])};
  const Motion& carried = motion_[std::size_t(body.parent)];
  const Vec3 through = x[body.a];
  const Vec3 turned{dot(rx, through), dot(ry, through), dot(rz, through)};
  const auto row = [&](Vec3 a) { return a.x * rx + a.y * ry + a.z * rz; };
  return {row(carried.rx), row(carried.ry), row(carried.rz), carried(through - turned)};
}

}  // namespace pliant
