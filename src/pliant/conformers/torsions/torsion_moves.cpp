// SPDX-License-Identifier: MIT
#include "pliant/conformers/torsions/torsion_moves.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "pliant/conformers/torsions/bond_turn_kinds.hpp"

namespace pliant {
namespace {

constexpr double whole = 1e-9;  // share of a bar's length

Vec3 unit(Vec3 v) { return (1.0 / norm(v)) * v; }

/// Where `centre` + `r` goes by a turn about an axis of length 1 through the centre (Rodrigues).
Vec3 turned(Vec3 centre, Vec3 r, Vec3 axis, Turn by) {
  return centre + by.cosine * r + by.sine * cross(axis, r) +
         ((1.0 - by.cosine) * dot(axis, r)) * axis;
}

/// The torsion i - a - b - j; none where three of them lie on a line.
std::optional<Turn> torsion(Vec3 i, Vec3 a, Vec3 b, Vec3 j) {
  const Vec3 axis = unit(b - a);
  const Vec3 from = cross(cross(axis, i - a), axis), to = cross(cross(axis, j - b), axis);
  const double lengths = norm(from) * norm(to);
  if (!(lengths > 1e-6)) return std::nullopt;
  return Turn{dot(from, to) / lengths, dot(cross(from, to), axis) / lengths};
}

/// The turn from where a torsion is to a usual one; where three atoms lie on a line there is none.
Turn usual_turn(const Rotor& rotor, RandomSequence& draws, std::span<const Vec3> x) {
  if (stays(rotor.kind)) return drawn_jitter(draws);
  const Turn wanted = drawn_usual(draws, rotor.kind);
  const auto now = torsion(x[rotor.beyond_a], x[rotor.a], x[rotor.b], x[rotor.beyond_b]);
  return now ? wanted * back(*now) : wanted;
}

}  // namespace

void turn(const Rotor& rotor, TorsionDraw how, RandomSequence& draws, std::span<Vec3> x) {
  const Vec3 origin = x[rotor.b], axis = unit(x[rotor.b] - x[rotor.a]);
  const Turn by = how == TorsionDraw::uniform && !stays(rotor.kind) ? drawn_angle(draws)
                                                                    : usual_turn(rotor, draws, x);
  for (Joint joint : rotor.turning) {
    const Vec3 r = x[joint] - origin;
    x[joint] = turned(origin, r, axis, by);
  }
}

/// The bond that moves becomes its mirror image in the plane of the other two, by the shortest
/// turn.
void invert(const Amine& amine, std::span<Vec3> x) {
  const Vec3 centre = x[amine.nitrogen];
  const Vec3 normal = unit(cross(x[amine.one] - centre, x[amine.other] - centre));
  const Vec3 was = unit(x[amine.turning.front()] - centre);
  const Vec3 is = was - 2.0 * dot(was, normal) * normal;
  const Vec3 across = cross(was, is);
  const double cosine = dot(was, is), sine = norm(across);
  if (!(sine > 1e-6)) return;
  const Vec3 axis = (1.0 / sine) * across;
  for (Joint joint : amine.turning) {
    const Vec3 r = x[joint] - centre;
    x[joint] = turned(centre, r, axis, {cosine, sine});
  }
}

void turn_over(const AmideTurn& amide, std::span<Vec3> x) {
  const Vec3 origin = x[amide.carbon], axis = unit(x[amide.nitrogen] - origin);
  for (Joint joint : amide.turning) {
    const Vec3 r = x[joint] - origin;
    x[joint] = origin - r + (2.0 * dot(axis, r)) * axis;
  }
}

TorsionMoves::TorsionMoves(const Framework& framework, const BodyPlan& plan,
                           std::span<const Vec3> start, ConformerMoves moves)
    : framework_(framework),
      own_plan_(drawing_plan(framework, start, moves)),
      plan_(own_plan_ ? *own_plan_ : plan),
      start_(start) {
  const BondChemistry chemistry(framework, start);
  find_loops(chemistry, moves);
  find_rings(chemistry, moves.ring_systems);
  find_rigid_systems(chemistry);
  find_amines(chemistry);
  find_amides(chemistry, moves);
}

/// Loops whose joints are all hinges are drawn, others bent.
void TorsionMoves::find_loops(const BondChemistry& chemistry, ConformerMoves moves) {
  const std::vector<bool> is_in_loop = bodies_in_loops(plan_);
  loop_bodies_ = std::count(is_in_loop.begin(), is_in_loop.end(), true);
  find_rotors(chemistry, is_in_loop, moves);
  LoopPlan loops = plan_loops(framework_, plan_, chemistry, is_in_loop, is_rotor_);
  if (!loops.hinges.empty())
    drawn_.emplace(plan_, std::move(loops));
  else if (loop_bodies_ > 0)
    bent_.emplace(plan_, is_in_loop);
}

/// A hinge outside of loops turns all bodies that hang on its own, first to last in the plan.
void TorsionMoves::find_rotors(const BondChemistry& chemistry, const std::vector<bool>& is_in_loop,
                               ConformerMoves moves) {
  const auto bodies = plan_.bodies();
  is_rotor_.assign(bodies.size(), false);
  for (std::uint32_t k = 0; k < bodies.size(); ++k) {
    if (bodies[k].turns() != 1 || is_in_loop[k]) continue;
    Rotor rotor{plan_.joint_at()[bodies[k].a], plan_.joint_at()[bodies[k].b], 0, 0, {}, {}};
    // Bodies that hang on this one follow it: the plan goes depth first.
    for (std::uint32_t m = k; m == k || (m < bodies.size() && bodies[m].parent >= std::int64_t{k});
         ++m)
      for (Slot place = bodies[m].first; place < bodies[m].last; ++place)
        if (is_own(place)) rotor.turning.push_back(plan_.joint_at()[place]);
    if (framework_.atoms() != nullptr) {
      if (chemistry.spins_alike(rotor.a, rotor.b) || chemistry.spins_alike(rotor.b, rotor.a))
        continue;
      rotor.beyond_a = chemistry.reference(rotor.a, rotor.b);
      rotor.beyond_b = chemistry.reference(rotor.b, rotor.a);
      rotor.kind = turn_of(chemistry, rotor.a, rotor.b);
      if (moves.both_hands && rotor.kind == BondTurn::atropisomer)
        rotor.kind = BondTurn::biaryl_flanked;
    }
    is_rotor_[k] = true;
    rotors_.push_back(std::move(rotor));
  }
}

/// Finds the forms of rings that hold bars and angles.
void TorsionMoves::find_rings(const BondChemistry& chemistry, bool with_systems) {
  for (FlexibleRing& ring :
       flexible_rings(framework_, chemistry, start_, {!drawn_, with_systems})) {
    std::vector<RingForm> forms;
    for (RingForm& form : ring.forms) {
      std::vector<Vec3> x(start_.begin(), start_.end());
      if (!forms.empty()) take_form(ring, form, x);
      if (holds_bars(x) && holds_limits(ring.angles, x)) forms.push_back(std::move(form));
    }
    ring.forms = std::move(forms);
    if (ring.forms.size() > 1)
      rings_.push_back(std::move(ring));
    else
      rigid_rings_.push_back(std::move(ring.atoms));
  }
}

/// Other rings that share bonds, in one body as a whole.
void TorsionMoves::find_rigid_systems(const BondChemistry& chemistry) {
  if (framework_.atoms() == nullptr) return;
  for (const std::vector<Bar>& bonds : chemistry.ring_blocks()) {
    std::vector<Joint> atoms;
    for (const Bar& bond : bonds) atoms.insert(atoms.end(), {bond.a, bond.b});
    std::sort(atoms.begin(), atoms.end());
    atoms.erase(std::unique(atoms.begin(), atoms.end()), atoms.end());
    const bool is_known =
        std::any_of(rings_.begin(), rings_.end(),
                    [&](const FlexibleRing& ring) { return ring.atoms == atoms; }) ||
        std::find(rigid_rings_.begin(), rigid_rings_.end(), atoms) != rigid_rings_.end();
    const bool is_flat = std::none_of(atoms.begin(), atoms.end(),
                                      [&](Joint atom) { return chemistry.is_tetrahedral(atom); });
    if (bonds.size() > atoms.size() && !is_known && !is_flat && is_in_one_body(atoms))
      rigid_rings_.push_back(std::move(atoms));
  }
}

bool TorsionMoves::is_in_one_body(std::span<const Joint> atoms) const {
  const auto joint_at = plan_.joint_at();
  const auto holds = [&](const PlanBody& body, Joint atom) {
    const auto own = joint_at.subspan(body.first, body.last - body.first);
    return std::find(own.begin(), own.end(), atom) != own.end() ||
           (body.parent >= 0 && (joint_at[body.a] == atom || joint_at[body.b] == atom));
  };
  const auto bodies = plan_.bodies();
  return std::any_of(bodies.begin(), bodies.end(), [&](const PlanBody& body) {
    return std::all_of(atoms.begin(), atoms.end(), [&](Joint atom) { return holds(body, atom); });
  });
}

/// Limits of other pairs are for resolving to keep.
bool TorsionMoves::holds_limits(std::span<const Bar> pairs, std::span<const Vec3> x) const {
  for (const Limit& limit : framework_.limits()) {
    const Joint a = std::min(limit.a, limit.b), b = std::max(limit.a, limit.b);
    const double now = distance(x[a], x[b]);
    if (now >= limit.least && now <= limit.most) continue;
    if (std::any_of(pairs.begin(), pairs.end(), [&](Bar p) { return p.a == a && p.b == b; }))
      return false;
  }
  return true;
}

/// Bars that reach further than across an atom may not like it: those of planar groups.
bool TorsionMoves::holds_bars(std::span<const Vec3> x) const {
  const auto bars = framework_.bars();
  for (BarIndex k = 0; k < bars.size(); ++k) {
    const double rest = framework_.rest_lengths()[k];
    if (!(std::abs(distance(x[bars[k].a], x[bars[k].b]) - rest) <= whole * rest)) return false;
  }
  return true;
}

/// An amine turns over by the bond outside rings that has the fewest atoms beyond it.
void TorsionMoves::find_amines(const BondChemistry& chemistry) {
  if (framework_.atoms() == nullptr) return;
  for (Joint atom = 0; atom < framework_.joint_count(); ++atom) {
    if (!chemistry.is_amine(atom)) continue;
    Amine found{atom, 0, 0, {}};
    for (const Link& bond : chemistry.bonds_at(atom)) {
      std::vector<Joint> turning = chemistry.beyond(bond.node, {atom});
      turning.insert(turning.begin(), bond.node);
      std::vector<Joint> staying;
      for (const Link& link : chemistry.bonds_at(atom))
        if (std::find(turning.begin(), turning.end(), link.node) == turning.end())
          staying.push_back(link.node);
      if (staying.size() != 2 || (!found.turning.empty() && turning.size() >= found.turning.size()))
        continue;
      found = {atom, staying[0], staying[1], std::move(turning)};
    }
    std::vector<Vec3> x(start_.begin(), start_.end());
    if (found.turning.empty()) continue;
    invert(found, x);
    if (holds_bars(x)) amines_.push_back(std::move(found));
  }
}

/// Where a bar still reaches across, it stays as it is.
void TorsionMoves::find_amides(const BondChemistry& chemistry, ConformerMoves moves) {
  for (const auto& [carbon, nitrogen] : turning_amides(framework_, chemistry, moves)) {
    std::vector<Joint> one = chemistry.beyond(carbon, {nitrogen});
    std::vector<Joint> other = chemistry.beyond(nitrogen, {carbon});
    AmideTurn found{carbon, nitrogen, std::move(one.size() < other.size() ? one : other)};
    std::vector<Vec3> x(start_.begin(), start_.end());
    turn_over(found, x);
    if (holds_bars(x)) amides_.push_back(std::move(found));
  }
}

void TorsionMoves::draw_amides(RandomSequence& draws, std::span<Vec3> x) const {
  for (const AmideTurn& amide : amides_)
    if (draws.below(2) == 1) turn_over(amide, x);
}

void TorsionMoves::draw_amines(RandomSequence& draws, std::span<Vec3> x) const {
  for (const Amine& amine : amines_)
    if (draws.below(2) == 1) invert(amine, x);
}

void TorsionMoves::draw_rings(RandomSequence& draws, std::span<Vec3> x) const {
  for (const FlexibleRing& ring : rings_) {
    std::vector<std::size_t> chairs;
    for (std::size_t k = 0; k < ring.forms.size(); ++k)
      if (ring.forms[k].is_chair) chairs.push_back(k);
    const bool sits = draws.below(3) > 0 && !chairs.empty();
    const std::size_t form =
        sits ? chairs[draws.below(chairs.size())] : draws.below(ring.forms.size());
    if (form > 0) take_form(ring, ring.forms[form], x);
  }
}

void TorsionMoves::turn_rotors(RandomSequence& draws, TorsionDraw how, std::span<Vec3> x) const {
  for (const Rotor& rotor : rotors_) turn(rotor, how, draws, x);
}

}  // namespace pliant
