// SPDX-License-Identifier: MIT
#include "pliant/resolve/bodies/pull/lane_step.hpp"

#include <algorithm>

namespace pliant {
namespace {

std::vector<LaneBody> bodies_of(const BodyPlan& plan) {
  std::vector<LaneBody> bodies;
  for (const PlanBody& body : plan.bodies())
    bodies.push_back(
        {body.parent, body.first, body.last, body.a, body.b, body.first_turn, body.turns()});
  return bodies;
}

Twist twist_at(const LaneTwist& twist, std::size_t lane) {
  Twist own;
  for (std::size_t k = 0; k < own.size(); ++k) own[k] = twist.of[k].of[lane];
  return own;
}

void add_at(std::size_t lane, double factor, const Twist& x, LaneTwist& y) {
  for (std::size_t k = 0; k < x.size(); ++k) y.of[k].of[lane] += factor * x[k];
}

void add_direction_at(std::size_t lane, double weight, const Twist& g, LaneInertia& inertia) {
  LaneValue* entry = inertia.of;
  for (std::size_t i = 0; i < g.size(); ++i) {
    const double scaled = weight * g[i];
    for (std::size_t j = 0; j <= i; ++j) (entry++)->of[lane] += scaled * g[j];
  }
}

LaneValue* values(std::vector<LaneTwist>& twists) { return twists.front().of; }

LaneValue each(const LaneValue& a, const LaneValue& b, double (*make)(double, double)) {
  LaneValue made;
  for (std::size_t lane = 0; lane < lane_count; ++lane)
    made.of[lane] = make(a.of[lane], b.of[lane]);
  return made;
}

LaneValue minus(const LaneValue& a) {
  return each(a, a, [](double x, double) { return -x; });
}

double over(double a, double b) { return a / (b + froda::tiny); }

}  // namespace

LaneStep::LaneStep(const BodyPlan& plan, const LaneKernels& kernels)
    : plan_(plan),
      kernels_(kernels),
      bodies_(bodies_of(plan)),
      inertia_(bodies_.size()),
      turns_(plan.turn_count()),
      springs_(plan.turn_count()),
      no_springs_(plan.turn_count()),
      x_(plan.place_count()),
      targets_(plan.place_count()),
      motion_(bodies_.size()) {
  for (auto* twists : {&forces_, &left_, &image_, &twists_, &direction_, &sum_})
    twists->resize(bodies_.size());
  for (auto* of_turns : {&left_of_turns_, &angles_, &direction_angles_, &sum_angles_})
    of_turns->resize(plan.turn_count());
  forest_ = {{bodies_.data(), bodies_.size()},
             plan.turn_count(),
             froda::damping,
             1.0,
             inertia_.data(),
             turns_.data(),
             springs_.data()};
}

void LaneStep::step(std::span<const LaneStepFrame, lane_count> frames) {
  load(frames);
  kernels_.bodies->go_inward(forest_, forces_.data());
  kernels_.bodies->go_outward(forest_, forces_.data(), moves_of(twists_, angles_));
  if (refined_ != 0) refine();
  move();
}

/// Positions, targets, springs and contacts of all frames. An empty lane computes on a copy of some
/// other frame, and what it finds is thrown away.
void LaneStep::load(std::span<const LaneStepFrame, lane_count> frames) {
  const auto somebody = std::find_if(frames.begin(), frames.end(),
                                     [](const LaneStepFrame& frame) { return frame.x != nullptr; });
  const double *x[lane_count], *targets[lane_count], *springs[lane_count];
  LaneMask has_targets = 0;
  refined_ = 0;
  conjugate_gradients_ = somebody->request->conjugate_gradients;
  for (std::size_t lane = 0; lane < lane_count; ++lane) {
    frames_[lane] = frames[lane];
    const LaneStepFrame& frame = frames[lane].x != nullptr ? frames[lane] : *somebody;
    const StepRequest& request = *frame.request;
    const auto bit = static_cast<LaneMask>(1U << lane);
    x[lane] = targets[lane] = &frame.x->x;
    if (!request.targets.empty()) {
      targets[lane] = &request.targets.front().x;
      has_targets |= bit;
    }
    if (!springs_.empty())
      springs[lane] =
          &(request.springs.empty() ? std::span<const TurnSpring>(no_springs_) : request.springs)
               .front()
               .weight;
    if (frames[lane].x != nullptr && conjugate_gradients_ > 0 && !request.rows.empty())
      refined_ |= bit;
  }
  kernels_.gather(x, 3 * x_.size(), &x_.front().x);
  if (has_targets != 0) kernels_.gather(targets, 3 * x_.size(), &targets_.front().x);
  if (!springs_.empty()) kernels_.gather(springs, 2 * springs_.size(), &springs_.front().weight);
  kernels_.bodies->gather(forest_, x_.data(), targets_.data(), has_targets, forces_.data());
  for (std::size_t lane = 0; lane < lane_count; ++lane)
    if (frames_[lane].x != nullptr) add_rows(lane, *frames_[lane].request, frames_[lane].x);
  if (refined_ != 0) left_ = forces_;
}

void LaneStep::add_rows(std::size_t lane, const StepRequest& request, const Vec3* x) {
  const auto body_at = plan_.body_at();
  for (const DistanceRow& row : request.rows) {
    const std::uint32_t i = body_at[row.i], j = body_at[row.j];
    const Twist gi = row.direction(x[row.i]), gj = row.direction(x[row.j]);
    add_direction_at(lane, froda::majorant * row.weight, gi, inertia_[i]);
    add_direction_at(lane, froda::majorant * row.weight, gj, inertia_[j]);
    add_at(lane, row.weight * row.gap, gi, forces_[i]);
    add_at(lane, -row.weight * row.gap, gj, forces_[j]);
  }
}

/// Conjugate gradients, as those of ArticulatedStep; lanes without contacts keep what they have.
void LaneStep::refine() {
  const LaneBodyKernels& kernels = *kernels_.bodies;
  const std::size_t twists = 6 * bodies_.size(), turns = turns_.size();
  if (refined_ != all_lanes) {
    first_ = twists_;
    first_angles_ = angles_;
  }
  direction_.swap(twists_);
  direction_angles_.swap(angles_);
  const LaneMoves moves = moves_of(twists_, angles_);
  std::fill(sum_.begin(), sum_.end(), LaneTwist{});
  std::fill(sum_angles_.begin(), sum_angles_.end(), LaneValue{});
  for (std::size_t t = 0; t < turns; ++t) left_of_turns_[t] = springs_[t].force;
  LaneValue before = kernels.product(forest_, moves_of(left_, left_of_turns_),
                                     moves_of(direction_, direction_angles_));
  for (int turn = 0;; ++turn) {
    const LaneValue step = each(before, apply_matrix(), over);
    kernels.add_scaled(step, values(direction_), twists, values(sum_));
    kernels.add_scaled(step, direction_angles_.data(), turns, sum_angles_.data());
    if (turn + 1 >= conjugate_gradients_) break;
    kernels.add_scaled(minus(step), values(image_), twists, values(left_));
    kernels.resist(forest_, step, direction_angles_.data(), left_of_turns_.data());
    forces_ = left_;
    kernels.push_inward(forest_, moves_of(forces_, left_of_turns_));
    kernels.go_outward(forest_, forces_.data(), moves);
    const LaneValue now = kernels.product(forest_, moves_of(left_, left_of_turns_), moves);
    const LaneValue ratio = each(now, before, over);
    before = now;
    kernels.add_to_scaled(values(twists_), ratio, twists, values(direction_));
    kernels.add_to_scaled(angles_.data(), ratio, turns, direction_angles_.data());
  }
  twists_.swap(sum_);
  angles_.swap(sum_angles_);
  if (refined_ == all_lanes) return;
  const auto others = static_cast<LaneMask>(~refined_);
  kernels.copy(others, values(first_), twists, values(twists_));
  kernels.copy(others, first_angles_.data(), turns, angles_.data());
}

/// image_ and its product with the direction. Contacts are added in the lanes that are refined.
LaneValue LaneStep::apply_matrix() {
  LaneValue sum = kernels_.bodies->apply_matrix(
      forest_, x_.data(), moves_of(direction_, direction_angles_), image_.data());
  for (std::size_t lane = 0; lane < lane_count; ++lane)
    if ((refined_ >> lane & 1) != 0)
      for (const DistanceRow& row : frames_[lane].request->rows)
        sum.of[lane] += apply_row(lane, row, frames_[lane].x);
  return sum;
}

double LaneStep::apply_row(std::size_t lane, const DistanceRow& row, const Vec3* x) {
  const auto body_at = plan_.body_at();
  const std::uint32_t i = body_at[row.i], j = body_at[row.j];
  const double apart = dot(row.along, froda::velocity(twist_at(direction_[i], lane), x[row.i]) -
                                          froda::velocity(twist_at(direction_[j], lane), x[row.j]));
  const double force = row.weight * apart;
  add_at(lane, force, row.direction(x[row.i]), image_[i]);
  add_at(lane, -force, row.direction(x[row.j]), image_[j]);
  return force * apart;
}

void LaneStep::move() {
  LaneValue bounds;
  double* x[lane_count];
  for (std::size_t lane = 0; lane < lane_count; ++lane) {
    const LaneStepFrame& frame = frames_[lane];
    bounds.of[lane] = frame.x != nullptr ? frame.request->bound : 0.0;
    x[lane] = frame.x != nullptr ? &frame.x->x : nullptr;
  }
  const LaneMoves moves = moves_of(twists_, angles_);
  const LaneValue share =
      kernels_.bodies->share_of(forest_, x_.data(), moves, bounds, froda::largest_turn);
  kernels_.bodies->move(forest_, moves, share, motion_.data(), x_.data());
  kernels_.scatter(&x_.front().x, 3 * x_.size(), x);
}

}  // namespace pliant
