// SPDX-License-Identifier: MIT
#include "pliant/resolve/bodies/tree/turn_springs.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>

#include "pliant/base/math/elementary.hpp"

namespace pliant {
namespace {

std::uint64_t key_of(Joint a, Joint b) {
  return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
}

template <std::size_t size>
std::array<Slot, size> places_of(const BodyPlan& plan, const std::array<Joint, size>& joints) {
  std::array<Slot, size> places;
  for (std::size_t k = 0; k < size; ++k) places[k] = plan.place_of(joints[k]);
  return places;
}

double signed_square(double x) { return x * std::abs(x); }

/// Whether a torsion t is no further from staggered than the angle whose triple has the cosine c,
/// given `least` = c |c|: -cos 3t >= c. For the point (x, y) at t, -cos 3t is x (3 y^2 - x^2) /
/// |(x, y)|^3; with squares that keep their signs, nothing is divided and no root is taken.
bool is_free(Vec3 a, Vec3 b, Vec3 c, Vec3 d, double least) {
  const Vec3 axis = c - b, one = cross(b - a, axis), other = cross(axis, d - c);
  const double x = dot(one, other), up = dot(b - a, other);
  const double xx = x * x, yy = norm_squared(axis) * up * up, all = xx + yy;
  const double triple = x * (3.0 * yy - xx);
  return signed_square(triple) >= least * (all * all * all);
}

/// The bodies that hang on one bond, by its joints.
class Hinges {
 public:
  explicit Hinges(const BodyPlan& plan) : plan_(plan) {
    const auto bodies = plan.bodies();
    for (std::uint32_t k = 0; k < bodies.size(); ++k)
      if (bodies[k].turns() == 1)
        body_at_[key_of(plan.joint_at()[bodies[k].a], plan.joint_at()[bodies[k].b])] = k;
  }

  const PlanBody* find(Joint b, Joint c) const {
    const auto found = body_at_.find(key_of(b, c));
    return found == body_at_.end() ? nullptr : &plan_.bodies()[found->second];
  }

  bool has(const PlanBody& body, Joint joint) const {
    const Slot place = plan_.place_of(joint);
    return place >= body.first && place < body.last;
  }

  /// The sign by which the body's turn adds to the torsion a-b-c-d; 0 where it does not turn a
  /// against d.
  double sign(const PlanBody& body, Joint a, Joint b, Joint d) const {
    const bool moves_last = has(body, d);
    if (moves_last == has(body, a)) return 0.0;
    const bool is_along = plan_.joint_at()[body.a] == b;
    return moves_last == is_along ? 1.0 : -1.0;
  }

 private:
  const BodyPlan& plan_;
  std::unordered_map<std::uint64_t, std::uint32_t> body_at_;
};

}  // namespace

TurnSprings::TurnSprings(const Framework& framework, const BodyPlan& plan) {
  const TorsionPreferences* const wanted = framework.torsion_preferences();
  if (wanted == nullptr) return;
  const Hinges hinges(plan);
  const auto hinge_of = [&](Joint a, Joint b, Joint c, Joint d) {
    const PlanBody* const body = hinges.find(b, c);
    return body == nullptr ? Hinge{} : Hinge{body->first_turn, hinges.sign(*body, a, b, d)};
  };
  for (const auto& [at, free] : wanted->staggered)
    if (const Hinge hinge = hinge_of(at[0], at[1], at[2], at[3]); hinge.sign != 0.0)
      staggered_.push_back(
          {places_of(plan, at), hinge, free, signed_square(exact_bits_cos(3.0 * free))});
  for (const auto& [at, reach] : wanted->backbone) {
    const Hinge phi = hinge_of(at[0], at[1], at[2], at[3]),
                psi = hinge_of(at[1], at[2], at[3], at[4]);
    if (phi.sign != 0.0 || psi.sign != 0.0)
      backbone_.push_back({places_of(plan, at), phi, psi, reach});
  }
  if (!empty()) springs_.resize(plan.turn_count());
}

std::span<const TurnSpring> TurnSprings::at(std::span<const Vec3> x, double weight) {
  std::fill(springs_.begin(), springs_.end(), TurnSpring{});
  for (const Staggered& torsion : staggered_) pull(torsion, x, weight);
  for (const Backbone& torsions : backbone_) pull(torsions, x, weight);
  return springs_;
}

void TurnSprings::pull(const Staggered& at, std::span<const Vec3> x, double weight) {
  const auto& p = at.places;
  if (is_free(x[p[0]], x[p[1]], x[p[2]], x[p[3]], at.least)) return;
  const double off = off_staggered(torsion_angle(x[p[0]], x[p[1]], x[p[2]], x[p[3]]));
  if (std::abs(off) > at.free) pull(at.hinge, (off > 0.0 ? at.free : -at.free) - off, weight);
}

void TurnSprings::pull(const Backbone& at, std::span<const Vec3> x, double weight) {
  const auto& p = at.places;
  const BackboneTurn turn =
      backbone_turn(torsion_angle(x[p[0]], x[p[1]], x[p[2]], x[p[3]]),
                    torsion_angle(x[p[1]], x[p[2]], x[p[3]], x[p[4]]), at.reach);
  if (turn.phi == 0.0 && turn.psi == 0.0) return;
  pull(at.phi, turn.phi, weight);
  pull(at.psi, turn.psi, weight);
}

void TurnSprings::pull(Hinge hinge, double angle, double weight) {
  if (hinge.sign == 0.0) return;
  TurnSpring& spring = springs_[hinge.turn];
  spring.weight += weight;
  spring.force += weight * hinge.sign * angle;
}

}  // namespace pliant
