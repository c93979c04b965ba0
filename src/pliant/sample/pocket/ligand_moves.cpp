// SPDX-License-Identifier: MIT
#include "pliant/sample/pocket/ligand_moves.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "pliant/base/math/superposition.hpp"
#include "pliant/conformers/torsions/bond_turn_kinds.hpp"
#include "pliant/conformers/torsions/loop_bending.hpp"
#include "pliant/sample/turns/course_measures.hpp"

namespace pliant {
namespace {

constexpr std::size_t most_steps = 8;     // each turns another bond, and fewer besides
constexpr std::size_t draws_a_step = 12;  // until the ligand fits
constexpr std::uint8_t hydrogen = 1;
constexpr std::size_t least_of_anchor = 3;
constexpr double most_overlap = 0.7;  // Angstrom: resolving takes away less
constexpr double touch = 4.0;         // Angstrom: more than any least distance
constexpr double least_change = 0.7;  // Angstrom, of the atom that is furthest off
constexpr double least_turn = 0.25 * std::numbers::pi;  // of the first bond
constexpr double longer = 1.2;                          // a stretched ligand than that of the start
constexpr double most_sp3_cosine = -0.44;               // of an angle of 116 degrees

/// Of ligands without hydrogens only planes and angles tell.
BondTurn turn_without_hydrogens(const BondChemistry& chemistry, std::span<const Vec3> start,
                                Joint a, Joint b) {
  const BondTurn kind = turn_of(chemistry, a, b);
  if (stays(kind)) return kind;
  const auto is_tetrahedral = [&](Joint atom) {
    const auto bonds = chemistry.bonds_at(atom);
    if (bonds.size() != 2) return chemistry.is_tetrahedral(atom);
    const Vec3 one = start[bonds[0].node] - start[atom], other = start[bonds[1].node] - start[atom];
    return dot(one, other) > most_sp3_cosine * norm(one) * norm(other);
  };
  return is_tetrahedral(a) && is_tetrahedral(b) ? BondTurn::staggered : BondTurn::any;
}

bool shows_hydrogens(const BondChemistry& chemistry, std::span<const Joint> joints) {
  return std::ranges::any_of(joints, [&](Joint joint) {
    return chemistry.is_hydrogen(joint) &&
           chemistry.element(chemistry.bonds_at(joint)[0].node) == 6;
  });
}

/// The joints of a body that are its own, and no copies at a cut.
void add_own(const BodyPlan& plan, const PlanBody& body, std::vector<Joint>& out) {
  for (Slot place = body.first; place < body.last; ++place)
    if (const Joint joint = plan.joint_at()[place]; plan.place_of(joint) == place)
      out.push_back(joint);
}

/// The joints of a body with the two that it turns about.
std::vector<Joint> unit_of(const BodyPlan& plan, const PlanBody& body) {
  const auto joint_at = plan.joint_at();
  std::vector<Joint> unit(joint_at.begin() + body.first, joint_at.begin() + body.last);
  if (body.parent >= 0) unit.insert(unit.end(), {joint_at[body.a], joint_at[body.b]});
  return unit;
}

/// What of a tree is ligand; with anchors if that is all of it.
LigandMolecule molecule_in(const BodyPlan& plan, const BodyTree& tree,
                           const std::vector<bool>& is_ligand) {
  LigandMolecule found;
  for (std::uint32_t k = tree.first; k < tree.last; ++k)
    add_own(plan, plan.bodies()[k], found.joints);
  const auto bonded = std::erase_if(found.joints, [&](Joint joint) { return !is_ligand[joint]; });
  if (bonded > 0) return found;
  std::uint32_t weight = 0;
  for (std::uint32_t k = tree.first; k < tree.last; ++k) {
    std::vector<Joint> unit = unit_of(plan, plan.bodies()[k]);
    if (unit.size() < least_of_anchor) continue;
    found.weights.push_back(weight += static_cast<std::uint32_t>(unit.size()));
    found.anchors.push_back(std::move(unit));
  }
  return found;
}

/// The joints of a body and of those that hang on it, which follow it: the plan goes depth first.
std::vector<Joint> turning_with(const BodyPlan& plan, std::uint32_t body) {
  const auto bodies = plan.bodies();
  std::vector<Joint> out;
  for (std::uint32_t m = body;
       m == body || (m < bodies.size() && bodies[m].parent >= std::int64_t{body}); ++m)
    add_own(plan, bodies[m], out);
  return out;
}

bool has_turned(const Rotor& at, std::span<const Vec3> before, std::span<const Vec3> x) {
  const auto angle = [&](std::span<const Vec3> of) {
    return torsion_angle(of[at.beyond_a], of[at.a], of[at.b], of[at.beyond_b]);
  };
  const double by = std::abs(angle(x) - angle(before));
  return std::min(by, 2.0 * std::numbers::pi - by) > least_turn;
}

}  // namespace

LigandMoves::LigandMoves(const Framework& framework, const BodyPlan& plan,
                         std::span<const Vec3> start, std::span<const Joint> ligand,
                         const BondChemistry& chemistry, std::vector<std::uint8_t> held,
                         std::vector<bool> turns_away)
    : framework_(framework),
      start_(start),
      held_(std::move(held)),
      turns_away_(std::move(turns_away)) {
  if (ligand.empty()) return;
  std::vector<bool> is_ligand(framework.joint_count(), false);
  for (const Joint joint : ligand) is_ligand[joint] = true;
  if (framework.sterics() != nullptr) rules_.emplace(framework);
  const std::vector<bool> is_in_loop = bodies_in_loops(plan);
  for (const BodyTree& tree : plan.trees()) {
    LigandMolecule found = molecule_in(plan, tree, is_ligand);
    if (found.joints.empty()) continue;
    find_rotors({plan, chemistry, is_ligand, is_in_loop}, tree, found);
    if (found.rotors.empty()) continue;
    find_surroundings(found);
    find_contacts(found);
    molecules_.push_back(std::move(found));
  }
}

/// The bonds of a tree that turn nothing but ligand.
void LigandMoves::find_rotors(const RotorSearch& in, const BodyTree& tree,
                              LigandMolecule& found) const {
  const auto& chemistry = in.chemistry;
  const auto joint_at = in.plan.joint_at();
  const auto bodies = in.plan.bodies();
  const bool has_hydrogens = shows_hydrogens(chemistry, found.joints);
  for (std::uint32_t k = tree.first; k < tree.last; ++k) {
    if (bodies[k].turns() != 1 || in.is_in_loop[k]) continue;
    Rotor rotor{joint_at[bodies[k].a], joint_at[bodies[k].b], 0, 0, {}, {}};
    if (chemistry.spins_alike(rotor.a, rotor.b) || chemistry.spins_alike(rotor.b, rotor.a))
      continue;
    rotor.turning = turning_with(in.plan, k);
    if (!std::ranges::all_of(rotor.turning, [&](Joint joint) { return in.is_ligand[joint]; }))
      continue;
    rotor.beyond_a = chemistry.reference(rotor.a, rotor.b);
    rotor.beyond_b = chemistry.reference(rotor.b, rotor.a);
    rotor.kind = has_hydrogens ? turn_of(chemistry, rotor.a, rotor.b)
                               : turn_without_hydrogens(chemistry, start_, rotor.a, rotor.b);
    found.rotors.push_back(std::move(rotor));
  }
}

/// All that may come near, wherever it is laid.
void LigandMoves::find_surroundings(LigandMolecule& molecule) const {
  Vec3 middle;
  for (const Joint joint : molecule.joints)
    middle += (1.0 / double(molecule.joints.size())) * start_[joint];
  double radius = 0.0;
  for (const Joint joint : molecule.joints)
    radius = std::max(radius, distance(start_[joint], middle));
  for (Joint k = 0; k < start_.size(); ++k)
    if (distance(start_[k], middle) < 2.0 * longer * radius + touch)
      molecule.surroundings.push_back(k);
}

void LigandMoves::find_contacts(LigandMolecule& molecule) const {
  const auto is_own = [&](Joint joint) {
    return std::ranges::find(molecule.joints, joint) != molecule.joints.end();
  };
  const auto limits = framework_.limits();
  for (LimitIndex k = 0; k < limits.size(); ++k)
    if (is_own(limits[k].a) != is_own(limits[k].b)) molecule.contacts.push_back(k);
}

bool LigandMoves::redraw(RandomSequence& draws, std::span<Vec3> x) const {
  bool is_redrawn = false;
  for (const LigandMolecule& molecule : molecules_)
    if (redraw(molecule, draws, x)) is_redrawn = true;
  return is_redrawn;
}

bool LigandMoves::redraw(const LigandMolecule& molecule, RandomSequence& draws,
                         std::span<Vec3> x) const {
  const std::vector<Vec3> before(x.begin(), x.end());
  const std::size_t count = molecule.rotors.size();
  for (std::size_t step = 0; step < most_steps; ++step) {
    const std::size_t must = draws.below(count);
    const std::size_t wanted = draws.below(std::max<std::size_t>(count >> step, 1));
    const double share = double(wanted) / double(count);
    for (std::size_t k = 0; k < draws_a_step; ++k) {
      for (std::size_t at = 0; at < count; ++at)
        if (at == must || draws.uniform() < share)
          turn(molecule.rotors[at], TorsionDraw::preferred, draws, x);
      lay_back(molecule, draws, before, x);
      if (has_turned(molecule.rotors[must], before, x) && differs(molecule, before, x) &&
          fits(molecule, false, x) && holds(molecule, x))
        return true;
      for (const Joint joint : molecule.joints) x[joint] = before[joint];
    }
  }
  return false;
}

/// Whether an atom is where none of its element was: rings that turn over by symmetry do not count.
bool LigandMoves::differs(const LigandMolecule& molecule, std::span<const Vec3> before,
                          std::span<const Vec3> x) const {
  if (framework_.atoms() == nullptr) return true;
  const auto& elements = framework_.atoms()->elements;
  return std::ranges::any_of(molecule.joints, [&](Joint a) {
    return elements[a] != hydrogen && std::ranges::none_of(molecule.joints, [&](Joint b) {
             return elements[a] == elements[b] && distance(x[a], before[b]) < least_change;
           });
  });
}

void LigandMoves::lay_back(const LigandMolecule& molecule, RandomSequence& draws,
                           std::span<const Vec3> before, std::span<Vec3> x) const {
  if (molecule.anchors.empty()) return;
  const std::uint64_t drawn = draws.below(molecule.weights.back());
  std::size_t anchor = 0;
  while (molecule.weights[anchor] <= drawn) ++anchor;
  std::vector<Vec3> now, goal;
  for (const Joint joint : molecule.anchors[anchor]) {
    now.push_back(x[joint]);
    goal.push_back(before[joint]);
  }
  const RigidMotion motion = superposition(now, goal);
  for (const Joint joint : molecule.joints) x[joint] = motion(x[joint]);
}

bool LigandMoves::fits(const LigandMolecule& molecule, bool beside_all,
                       std::span<const Vec3> x) const {
  if (!rules_) return true;
  for (const Joint a : molecule.joints)
    for (const Joint b : molecule.surroundings) {
      if (!beside_all && turns_away_[b]) continue;
      const double apart = norm_squared(x[a] - x[b]);
      if (a == b || apart >= rules_->largest() * rules_->largest()) continue;
      const double least = rules_->of(std::min(a, b), std::max(a, b)) - most_overlap;
      if (least > 0.0 && apart < least * least) return false;
    }
  return true;
}

bool LigandMoves::fits(std::span<const Vec3> x) const {
  return std::ranges::all_of(
      molecules_, [&](const LigandMolecule& molecule) { return fits(molecule, true, x); });
}

/// Whether all contacts are there that are held, and at least one if there are any.
bool LigandMoves::holds(const LigandMolecule& molecule, std::span<const Vec3> x) const {
  const std::vector<std::uint8_t> torn = torn_limits(framework_, x);
  bool is_bound = molecule.contacts.empty();
  for (const LimitIndex k : molecule.contacts) {
    if (torn[k] != 0 && held_[k] != 0) return false;
    is_bound = is_bound || torn[k] == 0;
  }
  return is_bound;
}

}  // namespace pliant
