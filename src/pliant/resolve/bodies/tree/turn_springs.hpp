// SPDX-License-Identifier: MIT
// Torsion preferences as springs on the turns of bodies. In the normal equations of articulated
// bodies the spring of a turn is added where its damping is, at no cost.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "pliant/framework/framework.hpp"
#include "pliant/resolve/bodies/tree/body_plan.hpp"

namespace pliant {

/// The spring on one turn.
struct TurnSpring {
  double weight = 0.0;  ///< Angstrom^2
  double force = 0.0;   ///< weight times the wanted angle (radians)
};

class TurnSprings {
 public:
  /// Takes the preferences whose bonds are hinges of the plan; other bonds cannot turn, or close
  /// loops.
  TurnSprings(const Framework& framework, const BodyPlan& plan);

  bool empty() const { return staggered_.empty() && backbone_.empty(); }
  /// (turns) the springs at `x` (places); 0 where a turn has none.
  std::span<const TurnSpring> at(std::span<const Vec3> x, double weight);

 private:
  /// The turn of a bond, and the sign by which it changes a torsion; sign 0 if it is no hinge.
  struct Hinge {
    std::uint32_t turn = 0;
    double sign = 0.0;
  };
  struct Staggered {
    std::array<Slot, 4> places;
    Hinge hinge;
    double free;
    double least;  ///< least -cos 3t of a torsion t without a pull, squared with its sign
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
