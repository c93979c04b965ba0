// SPDX-License-Identifier: MIT
// Closes loops of rigid units by their torsions (ring closure, inverse kinematics of closed
// chains).
//
// The units are placed outward along a tree, each where it fits best. Where the tree leaves a loop
// open, two units have different positions for the same joints. Repeatedly, the gaps r are closed
// by the smallest change d of the torsions that does so to first order:
//
//   d = - J^T (J J^T)^-1 r,   J = dr/dd: n x (x - a) for a joint x beyond a hinge n through a
//
// (Gauss, Newton; of least norm as in Deuflhard, Newton Methods for Nonlinear Problems, 4.4). A
// step without gain is halved. Bonds and angles remain exact throughout.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "pliant/base/math/best_fit.hpp"
#include "pliant/rigidity/unit_graph.hpp"
#include "pliant/rigidity/unit_shape.hpp"

namespace pliant {

class LoopClosure {
 public:
  /// Makes it from the units of `set`, whose shapes must be known, connected as in `graph`. Null if
  /// there are too many loops for dense equations. The arguments need not outlive it.
  static std::optional<LoopClosure> make(const UnitSet& set, const UnitShapes& shapes,
                                         const UnitGraph& graph);

  /// Moves `positions` (N) until no gap is wider than `gap` (Angstrom). Returns false, without
  /// moving anything, if the gaps stop closing.
  bool close(std::span<Vec3> positions, double gap);

 private:
  /// A unit on the loops, with its own copies of its joints.
  struct LoopUnit {
    std::uint32_t first = 0, count = 0;  ///< into joints_, shape_, places_
    std::int32_t parent = -1;            ///< index into units_; a smaller one
    std::uint32_t a = 0, b = 0;  ///< indices in joints_ of the joints shared with the parent
    std::uint32_t own_a = 0, own_b = 0;  ///< the same joints as the unit's own
    std::uint32_t first_turn = 0;        ///< into turns_: one for a hinge, three for a ball
    std::uint32_t turns = 0;
    bool mirror_allowed = false;
  };
  /// Two copies of one joint that must coincide.
  struct Gap {
    std::uint32_t one, other;  ///< indices into joints_
    std::int32_t unit, other_unit;
    std::uint32_t first;  ///< of its equations: three, or two for the second joint of a hinge
    /// For the second joint of a hinge: index in joints_ of the first one at `other_unit`.
    std::optional<std::uint32_t> first_of_hinge;
    std::size_t equations() const { return first_of_hinge ? 2 : 3; }
  };
  struct Turn {
    Vec3 axis, through;
  };
  /// The path from a unit to the first one: which ends of the present gap the unit turns.
  enum class Way : std::uint8_t { neither, one, other, both };

  LoopClosure() = default;
  void add_unit(const UnitSet& set, const UnitShapes& shapes, std::uint32_t index);
  void hang(std::size_t unit, std::size_t parent, const UnitConnection& at);
  std::uint32_t copy_of(std::size_t unit, Joint joint) const;
  void add_gaps(std::size_t unit, std::size_t owner, const UnitConnection& at);
  void place_all(std::span<const Vec3> positions, Vec3 origin);
  void place_by_rotation(const LoopUnit& unit);
  void place_by_torsion(const LoopUnit& unit);
  double measure_gaps();
  void find_turns();
  void fill_jacobian();
  void fill_matrix();
  bool solve_step();
  void set_directions(const Gap& gap);
  void fill_rows(const Gap& gap);
  void mark_ways(const Gap& gap);
  void fill_way(const Gap& gap, Way way);
  Vec3 turn_vector(const LoopUnit& unit) const;
  void apply(double share);
  void keep() { kept_ = places_; }

  std::vector<LoopUnit> units_;
  std::vector<Joint> joints_;  ///< copies, unit by unit
  std::vector<Vec3> shape_, places_, targets_, kept_;
  std::vector<Gap> gaps_;
  std::uint32_t equations_ = 0;
  std::array<Vec3, 3> directions_;
  std::vector<Turn> turns_;
  std::vector<RigidMotion> motions_;
  std::vector<Way> way_;  ///< (units) on the path to these ends of the present gap
  std::vector<double> jacobian_, matrix_, residual_, step_;
  std::vector<std::vector<std::uint32_t>> rows_of_turn_;  ///< of jacobian_, not 0, ascending
};

}  // namespace pliant
