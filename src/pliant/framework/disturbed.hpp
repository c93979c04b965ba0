// SPDX-License-Identifier: MIT
// Disturbed: which joints may have left the places at which every bar was whole.
#pragma once

#include <span>

#include "pliant/framework/framework.hpp"

namespace pliant {

/// What a resolve has to look at. Where few joints were disturbed a technique that knows how looks
/// only at what they reach, at a cost that does not depend on the size of the framework.
struct Disturbed {
  Joint root = 0;                      ///< where the technique begins
  bool all = true;                     ///< any joint may have moved, or some bar was broken before
  std::span<const Joint> joints = {};  ///< unless `all`: those that moved; the root is one of them
};

}  // namespace pliant
