// SPDX-License-Identifier: MIT
// Course: the way of a push that is no straight line. Domains turn along arcs.
#pragma once

#include <functional>
#include <span>

#include "pliant/base/vec3.hpp"

namespace pliant {

struct Course {
  /// Where the push wants the joints (N, Angstrom) at a share of the way, from 0 to 1; none:
  /// straight lines.
  std::function<void(double share, std::span<Vec3> out)> at;
  double length = 0.0;  ///< of the longest way of a joint (Angstrom)
  /// Angstrom: distance between intermediate targets, and the largest displacement of a body in a
  /// step, in place of those of the technique. Whole domains go in longer steps than residues.
  double leg = 3.0, bound = 3.0;
};

}  // namespace pliant
