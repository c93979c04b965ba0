// SPDX-License-Identifier: MIT
#include "pliant/sample/pocket/side_chain_moves.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include "pliant/base/math/axis_angle.hpp"
#include "pliant/conformers/torsions/loop_bending.hpp"

namespace pliant {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr int most_draws = 8;         // of one side chain, until it fits
constexpr double most_overlap = 0.7;  // Angstrom: resolving takes away less
constexpr double bond_reach = 1.6;    // Angstrom that a torsion more reaches further
constexpr double touch = 4.0;         // Angstrom: more than any least distance

/// The bonds about which joints of one residue alone turn.
std::vector<SideChainTorsion> turns_in_residues(const BodyPlan& plan, const AtomTable& atoms) {
  const std::vector<bool> is_in_loop = bodies_in_loops(plan);
  const auto bodies = plan.bodies();
  const auto joint_at = plan.joint_at();
  std::vector<SideChainTorsion> out;
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    if (bodies[k].turns() != 1 || is_in_loop[k]) continue;
    SideChainTorsion turn{0, joint_at[bodies[k].a], joint_at[bodies[k].b], 0, {}};
    const std::uint32_t residue = atoms.residue_of[turn.b];
    bool is_inside = true;
    // Bodies that hang on this one follow it: the plan goes depth first.
    for (std::size_t m = k; is_inside && m < bodies.size(); ++m) {
      if (m > k && bodies[m].parent < static_cast<std::int64_t>(k)) break;
      for (Slot place = bodies[m].first; is_inside && place < bodies[m].last; ++place) {
        turn.turning.push_back(joint_at[place]);
        is_inside = atoms.residue_of[joint_at[place]] == residue;
      }
    }
    if (is_inside) out.push_back(std::move(turn));
  }
  return out;
}

/// The joints of those names in a residue, as far as they are there.
std::vector<Joint> joints_along(const AtomTable& atoms, std::span<const Joint> residue,
                                std::span<const std::string_view> names) {
  std::vector<Joint> out;
  for (const std::string_view name : names) {
    const auto at =
        std::ranges::find_if(residue, [&](Joint joint) { return atoms.names[joint] == name; });
    if (at == residue.end()) break;
    out.push_back(*at);
  }
  return out;
}

/// A row, by its share.
const Rotamer& draw_rotamer(std::span<const Rotamer> rows, RandomSequence& draws) {
  int all = 0;
  for (const Rotamer& row : rows) all += row.percent;
  auto left = static_cast<int>(draws.below(static_cast<std::uint64_t>(all)));
  std::size_t k = 0;
  while ((left -= rows[k].percent) >= 0) ++k;
  return rows[k];
}

void turn_to(const SideChainTorsion& at, double degrees, std::span<Vec3> x) {
  const double now = torsion_angle(x[at.beyond_a], x[at.a], x[at.b], x[at.beyond_b]);
  const Vec3 origin = x[at.b], bond = origin - x[at.a];
  const Rotation rotation = rotation_by((1.0 / norm(bond)) * bond, degrees * degree - now);
  for (const Joint joint : at.turning) x[joint] = origin + rotation(x[joint] - origin);
}

void draw_torsions(const SideChain& side_chain, RandomSequence& draws, std::span<Vec3> x) {
  std::size_t next = 0;
  for (const std::span<const Rotamer> rows : side_chain.rotamers)
    for (const std::int16_t torsion : draw_rotamer(rows, draws).torsions) {
      if (torsion == no_torsion || next == side_chain.torsions.size()) continue;
      const double spread = rotamer_spread * (2.0 * draws.uniform() - 1.0);
      turn_to(side_chain.torsions[next++], torsion + spread, x);
    }
}

}  // namespace

SideChainMoves::SideChainMoves(const Framework& framework, const BodyPlan& plan,
                               std::span<const Vec3> start, const Pocket& place,
                               std::span<const std::uint32_t> residues_that_stay) {
  if (framework.atoms() == nullptr) return;
  const AtomTable& atoms = *framework.atoms();
  const std::vector<SideChainTorsion> turns = turns_in_residues(plan, atoms);
  std::vector<std::vector<Joint>> of_residue(atoms.residues.size());
  for (Joint k = 0; k < atoms.size(); ++k) of_residue[atoms.residue_of[k]].push_back(k);
  for (const std::uint32_t residue : place.residues) {
    if (std::ranges::find(residues_that_stay, residue) != residues_that_stay.end()) continue;
    const std::string_view name = amino_acid_of(atoms.residues[residue].name);
    add(joints_along(atoms, of_residue[residue], atoms_along_side_chain(name)), name, turns);
  }
  if (framework.sterics() == nullptr) return;
  rules_.emplace(framework);
  find_surroundings(start, place.ligand);
}

/// Adds the torsions about the bonds along `atoms`, as far as they turn.
void SideChainMoves::add(std::span<const Joint> atoms, std::string_view residue,
                         std::span<const SideChainTorsion> turns) {
  SideChain found;
  for (std::size_t k = 0; k + 3 < atoms.size(); ++k) {
    const auto turn = std::ranges::find_if(turns, [&](const SideChainTorsion& one) {
      return one.a == atoms[k + 1] && one.b == atoms[k + 2];
    });
    if (turn == turns.end()) break;
    found.torsions.push_back({atoms[k], turn->a, turn->b, atoms[k + 3], turn->turning});
    if (k == 1) continue;
    found.rotamers.push_back(rotamers_of(residue, k));
  }
  if (!found.torsions.empty()) side_chains_.push_back(std::move(found));
}

/// All that may come near, however both turn. A ligand may be anywhere.
void SideChainMoves::find_surroundings(std::span<const Vec3> start, std::span<const Joint> ligand) {
  std::vector<double> reach(start.size(), 0.0);  // from where a joint hangs on the backbone
  std::vector<Vec3> base(start.begin(), start.end());
  const auto reach_of = [](const SideChain& one) {
    return bond_reach * double(one.torsions.size() + 2);
  };
  for (const SideChain& one : side_chains_)
    for (const Joint joint : one.torsions.front().turning) {
      reach[joint] = reach_of(one);
      base[joint] = start[one.torsions.front().b];
    }
  for (const Joint joint : ligand) reach[joint] = HUGE_VAL;
  for (SideChain& one : side_chains_) {
    const Vec3 centre = start[one.torsions.front().b];
    for (Joint k = 0; k < start.size(); ++k)
      if (distance(base[k], centre) < reach[k] + reach_of(one) + touch)
        one.surroundings.push_back(k);
  }
}

bool SideChainMoves::fits(const SideChain& side_chain, std::span<const Vec3> x) const {
  if (!rules_) return true;
  for (const Joint a : side_chain.torsions.front().turning)
    for (const Joint b : side_chain.surroundings) {
      const double apart = norm_squared(x[a] - x[b]);
      if (a == b || apart >= rules_->largest() * rules_->largest()) continue;
      const double least = rules_->of(std::min(a, b), std::max(a, b)) - most_overlap;
      if (least > 0.0 && apart < least * least) return false;
    }
  return true;
}

void SideChainMoves::redraw(RandomSequence& draws, double share, std::span<Vec3> x) const {
  for (const SideChain& side_chain : side_chains_)
    if (draws.uniform() < share) redraw(side_chain, draws, x);
}

void SideChainMoves::make_room(RandomSequence& draws, double share, std::span<Vec3> x) const {
  for (const SideChain& side_chain : side_chains_)
    if (draws.uniform() < share || !fits(side_chain, x)) redraw(side_chain, draws, x);
}

void SideChainMoves::redraw(const SideChain& side_chain, RandomSequence& draws,
                            std::span<Vec3> x) const {
  const std::span<const Joint> turning = side_chain.torsions.front().turning;
  std::vector<Vec3> before;
  for (const Joint joint : turning) before.push_back(x[joint]);
  for (int k = 0; k < most_draws; ++k) {
    draw_torsions(side_chain, draws, x);
    if (fits(side_chain, x)) return;
  }
  for (std::size_t k = 0; k < turning.size(); ++k) x[turning[k]] = before[k];
}

}  // namespace pliant
