// SPDX-License-Identifier: MIT
// A unit that changes its shape, or whose shape nobody knows: loops of rigid units with freedom
// left (macrocycles, disulphides), rings without drawn positions. Made whole where it is, on its
// own; after that the pass may carry it about like any other unit.
#pragma once

#include <memory>
#include <vector>

#include "pliant/resolve/method/method.hpp"
#include "pliant/resolve/units/loop_closure.hpp"

namespace pliant {

class UnitLoop {
 public:
  /// `joints` of the unit, ascending, and all bars between them.
  UnitLoop(const Framework& framework, std::span<const Joint> joints,
           std::span<const BarIndex> bars, const Technique& technique,
           const ResolveOptions& options);

  /// Has loops closed by torsions from now on: `rigid` are the units of which this one is made, in
  /// joints of the framework. Without, or where that fails, technique `blocks` does it.
  void close_by_torsions(UnitSet rigid, const UnitShapes& shapes);

  /// Finds a shape in which all bars of the unit are within half the tolerance (the pass adds its
  /// own rounding), near where its joints are. Where that fails, and the positions before the push
  /// are given, it goes half of the way from there, a quarter, or none; else it begins a little way
  /// off. Moves none of `call.positions`. False if it fails: the shape is then as good as it got.
  bool find_shape(const ResolveCall& call);

  /// The places of the joints of the unit that find_shape() found.
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
