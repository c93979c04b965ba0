// SPDX-License-Identifier: MIT
// Disturbed: the joints that may have left the places at which every bar was whole.
#pragma once

#include <span>

#include "pliant/framework/framework.hpp"

namespace pliant {

/// Where a resolve has to look. If few joints were disturbed, some techniques look only at what
/// these reach, at a cost that does not depend on the size of the framework.
struct Disturbed {
  Joint root = 0;                      ///< where the technique begins
  bool all = true;                     ///< any joint may have moved, or some bar was broken before
  std::span<const Joint> joints = {};  ///< if not `all`: the joints that moved, the root among them
  /// Nothing but `joints` has moved since the resolver's last call, which was for the same walker:
  /// what it knows of near joints holds still.
  bool continues = false;
};

}  // namespace pliant
