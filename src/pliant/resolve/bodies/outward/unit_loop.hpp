// SPDX-License-Identifier: MIT
// A unit whose shape changes or is not known: loops of rigid units with freedom (macrocycles,
// disulphides), and rings without drawn positions. It is made whole separately, where it is; the
// pass may then move it like any other unit.
#pragma once

#include <memory>
#include <vector>

#include "pliant/resolve/bodies/outward/loop_closure.hpp"
#include "pliant/resolve/method/method.hpp"

namespace pliant {

class UnitLoop {
 public:
  /// `joints` of the unit are ascending; it has all bars between them.
  UnitLoop(const Framework& framework, std::span<const Joint> joints,
           std::span<const BarIndex> bars, const Technique& technique,
           const ResolveOptions& options);

  /// Closes loops by torsions from now on: `rigid` are the units that make up this one, in joints
  /// of the framework. Otherwise, or if that fails, technique `blocks` is used.
  void close_by_torsions(UnitSet rigid, const UnitShapes& shapes);

  /// Finds a shape with all bars of the unit within half the tolerance (the pass adds its own
  /// rounding), near the present positions. If that fails, and positions before the push are given,
  /// the unit follows the push by half, a quarter, or nothing; else it starts slightly displaced.
  /// Does not move `call.positions`. Returns false if it fails, with the best shape found.
  bool find_shape(const ResolveCall& call);

  /// Positions of the joints of the unit from find_shape().
  std::span<const Vec3> shape() const { return positions_; }

 private:
  void take(std::span<const Vec3> positions);
  void shake_by(double size, RandomKey key);
  bool make_whole(const ResolveCall& call);
  bool go_part_of_the_way(const ResolveCall& call);

  std::vector<Joint> joints_;
  Framework part_;  ///< the unit alone: joint k is joints_[k]
  Tolerance tolerance_;
  std::unique_ptr<Method> blocks_;
  std::optional<LoopClosure> closure_;
  double widest_gap_ = 0.0;      ///< that leaves every bar within the tolerance (Angstrom)
  double shortest_ = 0.0;        ///< rest length (Angstrom)
  std::vector<Vec3> positions_;  ///< of joints_
};

}  // namespace pliant
