// SPDX-License-Identifier: MIT
// Moves of a small molecule to another conformation, each exact in every bar:
// - rotors: atoms beyond a bond turn about it;
// - rings, and systems of small rings that share bonds, take another form (ring_moves.hpp): chair,
//   twist-boat, mirror image. Substituents move rigidly with the bonds of the ring at their atom:
//   axial ones become equatorial; handedness (chirality) does not change;
// - nitrogen of amines inverts: its smallest substituent moves to the other side of the other two
//   bonds;
// - tertiary amides, and others where asked, turn from cis to trans, where no bar reaches across
//   them;
// - flexible loops (rings of seven and more) get new torsions, amides in rings of nine and more
//   among them, and are closed (loop_draws.hpp), or are bent at random, step by step, if they are
//   only known as bodies (loop_bending.hpp).
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "pliant/base/random.hpp"
#include "pliant/conformers/rings/bond_chemistry.hpp"
#include "pliant/conformers/rings/ring_moves.hpp"
#include "pliant/conformers/torsions/conformer_framework.hpp"
#include "pliant/conformers/torsions/loop_bending.hpp"
#include "pliant/conformers/torsions/loop_draws.hpp"
#include "pliant/conformers/torsions/torsion_draws.hpp"
#include "pliant/framework/framework.hpp"
#include "pliant/resolve/bodies/tree/body_plan.hpp"

namespace pliant {

/// A bond about which part of the molecule turns.
struct Rotor {
  Joint a, b;                  ///< the bond; the atoms beyond b move
  Joint beyond_a, beyond_b;    ///< the torsion is beyond_a - a - b - beyond_b
  BondTurn kind;               ///< the kind of its usual torsions
  std::vector<Joint> turning;  ///< joints that move
};

/// Nitrogen that inverts, two neighbours that do not move, and the atoms that do, the third
/// neighbour first.
struct Amine {
  Joint nitrogen, one, other;
  std::vector<Joint> turning;
};

/// An amide that turns by 180 degrees, and the atoms that move: those of the smaller side.
struct AmideTurn {
  Joint carbon, nitrogen;
  std::vector<Joint> turning;
};

class TorsionMoves {
 public:
  /// All must outlive it. `start` (N, Angstrom).
  TorsionMoves(const Framework& framework, const BodyPlan& plan, std::span<const Vec3> start,
               ConformerMoves moves = {});

  std::span<const Rotor> rotors() const { return rotors_; }
  std::span<const FlexibleRing> rings() const { return rings_; }
  /// Rings and ring systems that are not planar and keep the form of the start.
  std::span<const std::vector<Joint>> rigid_rings() const { return rigid_rings_; }
  std::span<const Amine> amines() const { return amines_; }
  std::span<const AmideTurn> amides() const { return amides_; }
  /// Number of rigid units (bodies of the plan) in flexible loops.
  std::size_t loop_bodies() const { return loop_bodies_; }
  bool empty() const {
    return rotors_.empty() && rings_.empty() && amines_.empty() && amides_.empty() &&
           loop_bodies_ == 0;
  }

  /// Gives each ring of `x` (N, Angstrom) a random form; two of three draws take a chair, if there
  /// is one.
  void draw_rings(RandomSequence& draws, std::span<Vec3> x) const;
  /// Inverts each amine of `x` with probability one half.
  void draw_amines(RandomSequence& draws, std::span<Vec3> x) const;
  /// Turns each amide of `x` to its other form with probability one half.
  void draw_amides(RandomSequence& draws, std::span<Vec3> x) const;
  /// Draws all torsions of `x`.
  void turn_rotors(RandomSequence& draws, TorsionDraw how, std::span<Vec3> x) const;

  /// Gives flexible loops of `x` another form, if they can be drawn.
  void draw_loops(RandomSequence& draws, TorsionDraw how, std::span<Vec3> x) const {
    if (drawn_) drawn_->draw(draws, how, x);
  }
  /// Null if flexible loops are drawn, or if there are none.
  const LoopBending* bent() const { return bent_ ? &*bent_ : nullptr; }

 private:
  void find_loops(const BondChemistry& chemistry, ConformerMoves moves);
  void find_rotors(const BondChemistry& chemistry, const std::vector<bool>& is_in_loop,
                   ConformerMoves moves);
  void find_rings(const BondChemistry& chemistry, bool with_systems);
  void find_rigid_systems(const BondChemistry& chemistry);
  bool is_in_one_body(std::span<const Joint> atoms) const;
  void find_amines(const BondChemistry& chemistry);
  void find_amides(const BondChemistry& chemistry, ConformerMoves moves);
  /// Whether it is the joint's own place, not a copy at a cut.
  bool is_own(Slot place) const { return plan_.place_of(plan_.joint_at()[place]) == place; }
  bool holds_bars(std::span<const Vec3> x) const;
  bool holds_limits(std::span<const Bar> pairs, std::span<const Vec3> x) const;

  const Framework& framework_;
  std::optional<BodyPlan> own_plan_;  ///< in which amides of large rings turn, if there are some
  const BodyPlan& plan_;
  std::span<const Vec3> start_;
  std::size_t loop_bodies_ = 0;
  std::vector<bool> is_rotor_;  ///< (bodies)
  std::optional<LoopDraws> drawn_;
  std::optional<LoopBending> bent_;
  std::vector<Rotor> rotors_;
  std::vector<FlexibleRing> rings_;
  std::vector<std::vector<Joint>> rigid_rings_;
  std::vector<Amine> amines_;
  std::vector<AmideTurn> amides_;
};

/// Draws the torsion of a rotor of x (N).
void turn(const Rotor& rotor, TorsionDraw how, RandomSequence& draws, std::span<Vec3> x);

/// Inverts nitrogen in x (N).
void invert(const Amine& amine, std::span<Vec3> x);

/// Turns an amide of x (N) by 180 degrees.
void turn_over(const AmideTurn& amide, std::span<Vec3> x);

}  // namespace pliant
