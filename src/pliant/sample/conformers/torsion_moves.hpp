// SPDX-License-Identifier: MIT
// Ways in which a small molecule takes another conformation, each exact in every bar:
// - rotors: what hangs beyond a bond turns about it;
// - rings, and systems of small rings that share bonds, take another form (ring_moves.hpp): chair,
//   twist-boat, mirror image. What hangs on an atom is moved rigidly with the bonds of the ring
//   there, so that axial becomes equatorial, and handedness (chirality) is kept;
// - nitrogen of amines inverts: the smallest of what it bears is turned to the other side of the
//   other two bonds;
// - tertiary amides turn from cis to trans, where no bar reaches across them;
// - flexible loops (rings of seven and more) get new torsions and are closed (loop_draws.hpp);
// those
//   of which nothing is known but bodies are bent at random, step by step (loop_bending.hpp).
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "pliant/base/random.hpp"
#include "pliant/framework/framework.hpp"
#include "pliant/resolve/froda/bodies/body_plan.hpp"
#include "pliant/sample/conformers/conformer_framework.hpp"
#include "pliant/sample/conformers/loop_bending.hpp"
#include "pliant/sample/conformers/loop_draws.hpp"
#include "pliant/sample/conformers/torsion_draws.hpp"
#include "pliant/sample/rings/bond_chemistry.hpp"
#include "pliant/sample/rings/ring_moves.hpp"

namespace pliant {

/// A bond that can be turned about.
struct Rotor {
  Joint a, b;                  ///< the bond; what is beyond b moves
  Joint beyond_a, beyond_b;    ///< the torsion is beyond_a - a - b - beyond_b
  BondTurn kind;               ///< where its torsions usually are
  std::vector<Joint> turning;  ///< joints that move
};

/// Nitrogen that inverts, the two atoms that stay, and what moves, the atom bonded to it first.
struct Amine {
  Joint nitrogen, one, other;
  std::vector<Joint> turning;
};

/// An amide that turns by 180 degrees, and what moves: the smaller side.
struct AmideTurn {
  Joint carbon, nitrogen;
  std::vector<Joint> turning;
};

class TorsionMoves {
 public:
  /// All outlive it. `start` (N, Angstrom).
  TorsionMoves(const Framework& framework, const BodyPlan& plan, std::span<const Vec3> start);

  std::span<const Rotor> rotors() const { return rotors_; }
  std::span<const FlexibleRing> rings() const { return rings_; }
  /// Rings and ring systems that do not lie in a plane and keep the form of the start.
  std::span<const std::vector<Joint>> rigid_rings() const { return rigid_rings_; }
  std::span<const Amine> amines() const { return amines_; }
  std::span<const AmideTurn> amides() const { return amides_; }
  /// Rigid units (bodies of the plan) of flexible loops.
  std::size_t loop_bodies() const { return loop_bodies_; }
  bool empty() const {
    return rotors_.empty() && rings_.empty() && amines_.empty() && amides_.empty() &&
           loop_bodies_ == 0;
  }

  /// Gives each ring of `x` (N, Angstrom) one of its forms, by chance: of three draws two take a
  /// chair, if there are any.
  void draw_rings(RandomSequence& draws, std::span<Vec3> x) const;
  /// Inverts each amine of `x` or not, by chance.
  void draw_amines(RandomSequence& draws, std::span<Vec3> x) const;
  /// Turns each amide of `x` to its other form or not, by chance.
  void draw_amides(RandomSequence& draws, std::span<Vec3> x) const;
  /// Draws all torsions of `x`.
  void turn_rotors(RandomSequence& draws, TorsionDraw how, std::span<Vec3> x) const;

  /// Gives flexible loops of `x` another form, if they can be drawn.
  void draw_loops(RandomSequence& draws, TorsionDraw how, std::span<Vec3> x) const {
    if (drawn_) drawn_->draw(draws, how, x);
  }
  /// Null: flexible loops are drawn, or there are none.
  const LoopBending* bent() const { return bent_ ? &*bent_ : nullptr; }

 private:
  void find_loops(const BondChemistry& chemistry);
  void find_rotors(const BondChemistry& chemistry, const std::vector<bool>& is_in_loop);
  void find_rings(const BondChemistry& chemistry);
  void find_rigid_systems(const BondChemistry& chemistry);
  bool is_in_one_body(std::span<const Joint> atoms) const;
  void find_amines(const BondChemistry& chemistry);
  void find_amides(const BondChemistry& chemistry);
  /// Whether it is the joint's own place, and not a copy at a cut.
  bool is_own(Slot place) const { return plan_.place_of(plan_.joint_at()[place]) == place; }
  bool holds_bars(std::span<const Vec3> x) const;
  bool holds_limits(std::span<const Bar> pairs, std::span<const Vec3> x) const;
  void turn(const Rotor& rotor, TorsionDraw how, RandomSequence& draws, std::span<Vec3> x) const;

  const Framework& framework_;
  const BodyPlan& plan_;
  std::span<const Vec3> start_;
  std::size_t loop_bodies_ = 0;
  std::vector<bool> is_rotor_;  ///< of each body
  std::optional<LoopDraws> drawn_;
  std::optional<LoopBending> bent_;
  std::vector<Rotor> rotors_;
  std::vector<FlexibleRing> rings_;
  std::vector<std::vector<Joint>> rigid_rings_;
  std::vector<Amine> amines_;
  std::vector<AmideTurn> amides_;
};

/// Inverts nitrogen in x (N).
void invert(const Amine& amine, std::span<Vec3> x);

/// Turns an amide of x (N) by 180 degrees.
void turn_over(const AmideTurn& amide, std::span<Vec3> x);

}  // namespace pliant
