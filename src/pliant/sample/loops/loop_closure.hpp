// SPDX-License-Identifier: MIT
// Closes a loop of a chain that turns about its bonds: what hangs on its far end comes back to
// where it was. Lengths and angles are exact at every step, as nothing but turns is done.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "pliant/base/math/best_fit.hpp"
#include "pliant/base/vec3.hpp"

namespace pliant {

/// A bond about which all that follows along the chain turns.
struct LoopAxis {
  Vec3 origin;     ///< a point of it (Angstrom)
  Vec3 direction;  ///< unit length
};

/// Adds to `wishes` (K, radians) how much further the turns (K) should go, as far as the ends
/// allow.
using LoopWishes = std::function<void(std::span<const double> turns, std::span<double> wishes)>;

class LoopClosure {
 public:
  /// `axes` (K), in the order of the chain and where they lie at no turns; `end` (Angstrom): a
  /// point of what hangs on the last one.
  LoopClosure(std::vector<LoopAxis> axes, Vec3 end) : axes_(std::move(axes)), end_(end) {}

  /// (K) how what follows each axis has moved, after these turns (K, radians).
  std::span<const RigidMotion> motions(std::span<const double> turns);

  /// Changes turns as little as that can be done until the last motion is none, to 1e-12 Angstrom
  /// at `end`, and meanwhile towards `wishes`. False if there is no way: then `turns` are of no
  /// use.
  bool close(std::span<double> turns, const LoopWishes& wishes);

  /// How far the last motion takes the end, turns of it as if over 3 Angstrom.
  double gap() const;

 private:
  bool step(std::span<double> turns, std::span<const double> wishes);
  void find_columns();

  std::vector<LoopAxis> axes_;
  Vec3 end_;
  std::vector<RigidMotion> motions_;
  std::vector<double> columns_;  ///< (6 x K) how the end moves with each turn
};

}  // namespace pliant
