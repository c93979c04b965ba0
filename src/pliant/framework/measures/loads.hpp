// SPDX-License-Identifier: MIT
// Loads (constraint forces, Lagrange multipliers, stresses): how bars, limits, least distances and
// pins carry a pull, to first order in what moves.
#pragma once

#include <span>
#include <vector>

#include "pliant/framework/framework.hpp"

namespace pliant {

/// A force on a joint; loads are in its unit, whatever that is.
struct Load {
  Joint joint = 0;
  Vec3 force;
};

struct LoadOptions {
  double slack = 0.05;     ///< Angstrom: a limit or a pair is active this far before it holds
  double accuracy = 1e-4;  ///< of loads, as a share of the largest force
  int most_passes = 3000;  ///< over all that is active
};

/// Two joints that press against each other.
struct PressedPair {
  Joint a = 0, b = 0;
  double load = 0.0;  ///< above 0
};

struct Loads {
  std::vector<double> bars;          ///< (B) above 0: tension, below 0: compression
  std::vector<double> limits;        ///< (L) from 0: what pulls or presses its joints; 0 if slack
  std::vector<PressedPair> pressed;  ///< pairs at their least distance that carry something
  std::vector<double> pins;          ///< (N) what holds each pinned joint, 0 of the others
  std::vector<Vec3> motion;          ///< (N) how all joints give way: the force itself if free
  int passes = 0;

  /// Along `direction`, the share of its own motion with nothing else that a joint has left: 1 if
  /// it is free, 1 / n if it drags n joints along.
  double yields(Joint joint, Vec3 direction) const {
    return dot(motion[joint], direction) / norm_squared(direction);
  }
};

/// Joints of equal mass at `positions` (N, Angstrom), whose bars are whole, give way to `pull`
/// as Gauss' principle of least constraint has it: no bar changes its length, and no limit or pair
/// that is active goes further the way that it holds. Where more holds than is needed, the load is
/// shared. By accelerated projected gradients (Nesterov; Mazhar et al., ACM Trans. Graph. 34 (2015)
/// 32).
Loads find_loads(const Framework& framework, std::span<const Vec3> positions,
                 std::span<const Load> pull, const LoadOptions& options = {});

}  // namespace pliant
