// SPDX-License-Identifier: MIT
#include "pliant/conformers/torsions/loop_bending.hpp"

#include <algorithm>
#include <cmath>

namespace pliant {
namespace {

constexpr double loop_push = 3.0;  // Angstrom: how far a typical joint of a loop is asked to go

}  // namespace

std::vector<bool> bodies_in_loops(const BodyPlan& plan) {
  const auto bodies = plan.bodies();
  std::vector<bool> is_in_loop(bodies.size(), false);
  for (const LoopCut& cut : plan.cuts()) {
    std::int64_t one = plan.body_at()[cut.copy], other = plan.body_at()[cut.joint];
    while (one != other) {
      std::int64_t& later = one > other ? one : other;  // a parent comes before
      is_in_loop[std::size_t(later)] = true;
      later = bodies[std::size_t(later)].parent;
    }
  }
  return is_in_loop;
}

/// Pushes by a field of strain and one of bending, d = a (u.r) w + b (u'.r)(v'.r) w', r from the
/// middle of the loops in units of their size: neighbours go nearly alike. What hangs on a loop
/// goes with the middle of the unit that it hangs on.
void LoopBending::push(RandomSequence& draws, std::span<Vec3> targets) const {
  const auto bodies = plan_.bodies();
  std::vector<Vec3> middle(bodies.size()), push(bodies.size());
  for (std::size_t k = 0; k < bodies.size(); ++k) middle[k] = middle_of(bodies[k], targets);
  const auto count = double(std::count(is_in_loop_.begin(), is_in_loop_.end(), true));
  Vec3 centre{};
  for (std::size_t k = 0; k < bodies.size(); ++k)
    if (is_in_loop_[k]) centre += (1.0 / count) * middle[k];
  double size = 0.0;
  for (std::size_t k = 0; k < bodies.size(); ++k)
    if (is_in_loop_[k]) size += norm_squared(middle[k] - centre);
  size = std::sqrt(size / count) + 1e-6;
  const Vec3 u = draws.direction(), w = draws.direction(), u2 = draws.direction(),
             v2 = draws.direction(), w2 = draws.direction();
  const double strain = loop_push * (2.0 * draws.uniform() - 1.0),
               bend = loop_push * (2.0 * draws.uniform() - 1.0);
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    const Vec3 r = (1.0 / size) * (middle[k] - centre);
    if (is_in_loop_[k])
      push[k] = (strain * dot(u, r)) * w + (bend * dot(u2, r) * dot(v2, r)) * w2;
    else if (bodies[k].parent >= 0)
      push[k] = push[std::size_t(bodies[k].parent)];
    for (Slot place = bodies[k].first; place < bodies[k].last; ++place)
      if (const Joint joint = plan_.joint_at()[place]; plan_.place_of(joint) == place)
        targets[joint] += push[k];
  }
}

Vec3 LoopBending::middle_of(const PlanBody& body, std::span<const Vec3> x) const {
  Vec3 sum{};
  for (Slot place = body.first; place < body.last; ++place) sum += x[plan_.joint_at()[place]];
  return (1.0 / double(std::max<Slot>(body.last - body.first, 1))) * sum;
}

}  // namespace pliant
