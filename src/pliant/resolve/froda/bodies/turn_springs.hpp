// SPDX-License-Identifier: MIT
// Torsion preferences as springs on the turns of bodies. A spring on a turn stands in the normal
// equations of articulated bodies where the damping of that turn does, so that it costs nothing
// there.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "pliant/framework/framework.hpp"
#include "pliant/resolve/froda/bodies/body_plan.hpp"

namespace pliant {

/// What pulls on one turn.
struct TurnSpring {
  double weight = 0.0;  ///< Angstrom^2
  double force = 0.0;   ///< weight times the angle that it wants, radians
};

class TurnSprings {
 public:
  /// Those preferences whose bonds are hinges of the plan; others cannot turn, or close loops.
  TurnSprings(const Framework& framework, const BodyPlan& plan);

  bool empty() const { return staggered_.empty() && backbone_.empty(); }
  /// (turns) what pulls on `x` (places); where nothing does both are 0.
  std::span<const TurnSpring> at(std::span<const Vec3> x, double weight);

 private:
  /// Of a hinge: which turn, and the sign by which it adds to a torsion; 0: no hinge.
  struct Hinge {
    std::uint32_t turn = 0;
    double sign = 0.0;
  };
  struct Staggered {
    std::array<Slot, 4> places;
    Hinge hinge;
    double free;
    double least;  ///< of -cos 3t of a torsion t that is free, as a square with its sign
  };
  struct Backbone {
    std::array<Slot, 5> places;
    Hinge phi, psi;
    double reach;
  };

  void pull(const Staggered& at, std::span<const Vec3> x, double weight);
  void pull(const Backbone& at, std::span<const Vec3> x, double weight);
  void pull(Hinge hinge, double angle, double weight);

  std::vector<Staggered> staggered_;
  std::vector<Backbone> backbone_;
  std::vector<TurnSpring> springs_;
};

}  // namespace pliant
