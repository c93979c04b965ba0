// SPDX-License-Identifier: MIT
#include "pliant/conformers/torsions/loop_closing.hpp"

#include <algorithm>
#include <cmath>

namespace pliant {
namespace {

// How much it counts where loops are open (Angstrom), atoms too near, or a hydrogen bond too long,
// and where torsions are off what is usual (sine).
constexpr double gap_weight = 20.0, overlap_weight = 3.0, bond_weight = 0.3;
constexpr double torsion_weight = 3.0, ester_weight = 10.0, amide_weight = 40.0;
constexpr double loop_damping = 0.05;
constexpr double largest_turn = 0.35;  // radians, of a step
constexpr int relaxing_steps = 40;
constexpr double still = 1e-3;  // radians: nothing turns any more
/// Angstrom, H..O: nearer than the one it is bonded, and from the other on it is drawn near.
constexpr double bonded = 2.0, bond_reach = 3.5;
constexpr int closing_steps = 30;
constexpr double widest_gap = 1e-13;  // Angstrom
/// Two joints of a cut keep their distance, so that one of their six rows says nothing new.
constexpr double redundant = 1e-11;

double of_axis(Vec3 x, std::size_t axis) { return axis == 0 ? x.x : (axis == 1 ? x.y : x.z); }

}  // namespace

LoopClosing::LoopClosing(const BodyPlan& plan, const LoopPlan& loops, std::span<const Vec3> x,
                         double reach)
    : plan_(plan), loops_(loops), reach_(reach), equations_(loops.hinges) {
  for (Joint joint : plan.joint_at()) x_.push_back(x[joint]);
  for (const LoopPair& pair : loops.pairs)
    farthest_ = std::max({farthest_, reach * pair.least, bond_reach});
  for (const LoopTorsion& torsion : loops.torsions) at_start_.push_back(torsion_now(torsion));
}

void LoopClosing::write(std::span<Vec3> x) const {
  for (Joint joint = 0; joint < x.size(); ++joint) x[joint] = x_[plan_.place_of(joint)];
}

/// (A. Blondel, M. Karplus, J. Comput. Chem. 17 (1996) 1132.) Where three places lie on a line
/// nothing is known of it.
LoopClosing::Bend LoopClosing::bend_of(const LoopTorsion& torsion) const {
  const Vec3 j = x_[torsion.at[1]], k = x_[torsion.at[2]];
  const Vec3 f = x_[torsion.at[0]] - j, g = j - k, h = x_[torsion.at[3]] - k;
  const Vec3 a = cross(f, g), b = cross(h, g);
  const double aa = norm_squared(a), bb = norm_squared(b), length = norm(g);
  if (!(aa > 1e-6 && bb > 1e-6)) return {};
  const double both = std::sqrt(aa * bb);
  const Vec3 first = (-length / aa) * a, last = (length / bb) * b;
  const Vec3 shift = (dot(f, g) / (aa * length)) * a - (dot(h, g) / (bb * length)) * b;
  return {{dot(a, b) / both, dot(cross(b, a), g) / (both * length)},
          {first, shift - first, -1.0 * shift - last, last}};
}

/// About the axis from a to b.
void LoopClosing::turn(const LoopHinge& hinge, Turn by) {
  const Vec3 origin = x_[hinge.b], along = origin - x_[hinge.a];
  const Vec3 axis = (1.0 / norm(along)) * along;
  for (Slot place = hinge.first; place < hinge.last; ++place) {
    const Vec3 r = x_[place] - origin;
    x_[place] = origin + by.cosine * r + by.sine * cross(axis, r) +
                ((1.0 - by.cosine) * dot(axis, r)) * axis;
  }
}

void LoopClosing::draw_amides(RandomSequence& draws) {
  is_cis_.clear();
  for (const LoopTorsion& torsion : loops_.torsions)
    is_cis_.push_back(torsion.kind == BondTurn::ring_amide && draws.below(2) == 1);
}

/// Torsions that no hinge turns alone follow.
void LoopClosing::open(RandomSequence& draws, TorsionDraw how) {
  for (std::size_t k = 0; k < loops_.torsions.size(); ++k) {
    const LoopTorsion& torsion = loops_.torsions[k];
    if (torsion.hinge < 0) continue;
    const Turn by = opened(k, draws, how);
    turn(loops_.hinges[std::size_t(torsion.hinge)], torsion.is_forward ? by : back(by));
  }
}

/// How much a torsion is turned: to one that is usual for its bond, or by any angle; esters stay as
/// they are, amides go to what was drawn.
Turn LoopClosing::opened(std::size_t torsion, RandomSequence& draws, TorsionDraw how) const {
  const LoopTorsion& at = loops_.torsions[torsion];
  if (stays(at.kind)) return drawn_jitter(draws);
  if (at.kind == BondTurn::ring_amide)
    return Turn{is_cis_[torsion] ? 1.0 : -1.0, 0.0} * drawn_jitter(draws) * back(torsion_now(at));
  if (how == TorsionDraw::uniform) return drawn_angle(draws);
  return drawn_usual(draws, at.kind) * back(torsion_now(at));
}

/// Adds the equations of gaps; returns the widest gap.
double LoopClosing::add_gaps(double weight) {
  constexpr std::array<Vec3, 3> axes{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  double widest = 0.0;
  for (const auto [copy, joint] : plan_.cuts()) {
    const Vec3 gap = x_[copy] - x_[joint];
    widest = std::max(widest, norm(gap));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      equations_.begin_row();
      equations_.add_to_row(copy, axes[axis]);
      equations_.add_to_row(joint, -1.0 * axes[axis]);
      equations_.end_row(of_axis(gap, axis), weight);
    }
  }
  return widest;
}

/// How far a torsion is from the nearest usual one, that of an ester from that of the start.
Turn LoopClosing::off_usual(std::size_t torsion, Turn now) const {
  const BondTurn kind = loops_.torsions[torsion].kind;
  return now * back(stays(kind) ? at_start_[torsion] : nearest_usual(now, kind));
}

double LoopClosing::weight_of(const LoopTorsion& torsion, TorsionDraw how) const {
  if (torsion.kind == BondTurn::ring_amide) return amide_weight;
  if (stays(torsion.kind)) return ester_weight;
  return how == TorsionDraw::preferred && torsion.kind != BondTurn::any ? torsion_weight : 0.0;
}

void LoopClosing::add_torsions(TorsionDraw how) {
  for (std::size_t k = 0; k < loops_.torsions.size(); ++k) {
    const LoopTorsion& torsion = loops_.torsions[k];
    const double weight = weight_of(torsion, how);
    if (weight == 0.0) continue;
    const Bend bend = bend_of(torsion);
    equations_.begin_row();
    for (std::size_t m = 0; m < 4; ++m) equations_.add_to_row(torsion.at[m], bend.gradient[m]);
    equations_.end_row(off_usual(k, bend.now).sine, weight);
  }
}

/// Asks nothing of atoms that are far enough apart.
LoopClosing::Wish LoopClosing::apart_wish(const LoopPair& pair, double length) const {
  const double least = (pair.bond == HydrogenBond::none ? reach_ : 1.0) * pair.least;
  if (length < least) return {length - least, overlap_weight};
  if (pair.bond == HydrogenBond::to_hydrogen && length > bonded && length < bond_reach)
    return {length - bonded, bond_weight};
  return {};
}

void LoopClosing::add_pairs() {
  for (const LoopPair& pair : loops_.pairs) {
    const Vec3 apart = x_[pair.i] - x_[pair.j];
    const double square = norm_squared(apart);
    if (square >= farthest_ * farthest_ || !(square > 1e-12)) continue;
    const double length = std::sqrt(square);
    add_pair(pair, apart, length, apart_wish(pair, length));
  }
}

void LoopClosing::add_pair(const LoopPair& pair, Vec3 apart, double length, Wish wish) {
  if (wish.weight == 0.0) return;
  equations_.begin_row();
  equations_.add_to_row(pair.i, (1.0 / length) * apart);
  equations_.add_to_row(pair.j, (-1.0 / length) * apart);
  equations_.end_row(wish.off, wish.weight);
}

/// Turns by the solution of the equations, but none by more than `largest_turn`; returns the
/// largest.
double LoopClosing::turn_all() {
  const std::span<const double> turns = equations_.solve();
  double largest = 0.0;
  for (double d : turns) largest = std::max(largest, std::abs(d));
  const double share = largest > largest_turn ? largest_turn / largest : 1.0;
  for (std::size_t k = 0; k < turns.size(); ++k)
    turn(loops_.hinges[k], of_half_tangent(0.5 * share * turns[k]));
  return share * largest;
}

void LoopClosing::relax(TorsionDraw how) {
  for (int step = 0; step < relaxing_steps; ++step) {
    equations_.begin(x_, loop_damping);
    add_gaps(gap_weight);
    add_torsions(how);
    add_pairs();
    if (turn_all() < still) break;
  }
}

bool LoopClosing::close() {
  for (int step = 0; step < closing_steps; ++step) {
    equations_.begin(x_, 0.0);
    if (add_gaps(1.0) < widest_gap) return true;
    equations_.add_damping(redundant);
    turn_all();
  }
  return false;
}

double LoopClosing::twist() const {
  double worst = 0.0;
  for (const LoopTorsion& torsion : loops_.torsions)
    if (torsion.kind == BondTurn::ring_amide)
      worst = std::max(worst, std::abs(torsion_now(torsion).sine));
  return worst;
}

double LoopClosing::strain(TorsionDraw how) const {
  double sum = 0.0;
  for (const LoopPair& pair : loops_.pairs) {
    const double length = distance(x_[pair.i], x_[pair.j]);
    const Wish wish = apart_wish(pair, length);
    sum += wish.weight * wish.off * wish.off;
    constexpr double unbonded = bond_weight * (bond_reach - bonded) * (bond_reach - bonded);
    if (pair.bond == HydrogenBond::to_hydrogen && length < bond_reach) sum -= unbonded;
  }
  for (std::size_t k = 0; k < loops_.torsions.size(); ++k) {
    const double sine = off_usual(k, torsion_now(loops_.torsions[k])).sine;
    sum += weight_of(loops_.torsions[k], how) * sine * sine;
  }
  return sum;
}

}  // namespace pliant
