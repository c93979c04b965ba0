// SPDX-License-Identifier: MIT
#include "pliant/resolve/bodies/tree/articulated_pass.hpp"

#include <array>
#include <cmath>
#include <ranges>

namespace pliant {

using froda::add_direction;
using froda::add_scaled;

ArticulatedPass::ArticulatedPass(const BodyPlan& plan, const WorkingTrees& working, double damping,
                                 double square_unit)
    : plan_(plan), working_(working), damping_(damping), square_unit_(square_unit) {
  fit();
}

void ArticulatedPass::fit() {
  inertia_.resize(plan_.bodies().size());
  force_.resize(plan_.bodies().size());
  turns_.resize(plan_.turn_count());
}

void ArticulatedPass::gather(std::span<const Vec3> x, std::span<const Vec3> targets) {
  const auto bodies = plan_.bodies();
  for (const std::uint32_t k : working_.bodies()) {
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
  set_turns(x);
}

void ArticulatedPass::set_turns(std::span<const Vec3> x) {
  constexpr std::array<Vec3, 3> axes{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  for (const std::uint32_t k : working_.bodies()) {
    const PlanBody& body = plan_.bodies()[k];
    const auto own = turns_of(body);
    if (own.size() == 1) {
      const Vec3 along = x[body.b] - x[body.a];
      const Vec3 axis = (1.0 / norm(along)) * along;
      own[0].s = turn_of(axis, x[body.a]);
    } else {
      for (std::size_t t = 0; t < own.size(); ++t) own[t].s = turn_of(axes[t], x[body.a]);
    }
  }
}

void ArticulatedPass::add_pulls(std::span<const Vec3> x, std::span<const PlacePull> pulls) {
  for (const PlacePull& pull : pulls) {
    const std::uint32_t body = plan_.body_at()[pull.at];
    add_point(inertia_[body], force_[body], x[pull.at], pull.way, pull.weight);
  }
}

void ArticulatedPass::add_rows(std::span<const Vec3> x, std::span<const DistanceRow> rows,
                               double factor) {
  const auto body_at = plan_.body_at();
  for (const DistanceRow& row : rows) {
    const std::uint32_t i = body_at[row.i];
    const Twist gi = row.direction(x[row.i]);
    add_scaled(row.weight * row.gap, gi, force_[i]);
    if (row.j == DistanceRow::still) {
      add_direction(row.weight, gi, inertia_[i]);
      continue;
    }
    const std::uint32_t j = body_at[row.j];
    const Twist gj = row.direction(x[row.j]);
    add_direction(factor * row.weight, gi, inertia_[i]);
    add_direction(factor * row.weight, gj, inertia_[j]);
    add_scaled(-row.weight * row.gap, gj, force_[j]);
  }
}

void ArticulatedPass::go_inward(std::span<const TurnSpring> springs) {
  const auto bodies = plan_.bodies();
  for (const std::uint32_t k : std::views::reverse(working_.bodies()))
    if (bodies[k].parent >= 0) pass_on(bodies[k], k, springs);
}

/// Takes the turns of a body out of its inertia and force, and adds what is left to its parent's.
void ArticulatedPass::pass_on(const PlanBody& body, std::size_t index,
                              std::span<const TurnSpring> springs) {
  Inertia& m = inertia_[index];
  Twist& p = force_[index];
  const auto own = turns_of(body);
  for (std::size_t t = own.size(); t-- > 0;) {
    Turn& turn = own[t];
    turn.u = froda::product(m, turn.s);
    const TurnSpring spring = springs.empty() ? TurnSpring{} : springs[body.first_turn + t];
    turn.inverse = 1.0 / (froda::dot(turn.s, turn.u) + damping_ + spring.weight);
    turn.force = froda::dot(turn.s, p) + spring.force;
    add_scaled(-turn.force * turn.inverse, turn.u, p);
    add_direction(-turn.inverse, turn.u, m);
  }
  const auto parent = static_cast<std::size_t>(body.parent);
  double* const above = inertia_[parent].data();
  for (std::size_t i = 0; i < m.size(); ++i) above[i] += m[i];
  add_scaled(1.0, p, force_[parent]);
}

void ArticulatedPass::push_inward(std::vector<Twist>& forces, std::span<const double> of_turns) {
  const auto bodies = plan_.bodies();
  for (const std::uint32_t k : std::views::reverse(working_.bodies())) {
    if (bodies[k].parent < 0) continue;
    carry(
        k, forces[k], [&](std::uint32_t turn, double force) { turns_[turn].force = force; },
        of_turns);
    add_scaled(1.0, forces[k], forces[std::size_t(bodies[k].parent)]);
  }
}

void ArticulatedPass::go_outward(const std::vector<Twist>& forces, BodyMotions& out) const {
  const auto bodies = plan_.bodies();
  for (const std::uint32_t k : working_.bodies()) {
    const PlanBody& body = bodies[k];
    if (body.parent < 0) {
      out.twists[k] = answer_of_root(k, forces[k]);
      continue;
    }
    Twist v = out.twists[std::size_t(body.parent)];
    for (std::uint32_t t = body.first_turn; t < body.first_turn + body.turns(); ++t) {
      const Turn& turn = turns_[t];
      out.angles[t] = (turn.force - froda::dot(turn.u, v)) * turn.inverse;
      add_scaled(out.angles[t], turn.s, v);
    }
    out.twists[k] = v;
  }
}

}  // namespace pliant
