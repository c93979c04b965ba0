// SPDX-License-Identifier: MIT
// Options of resolving many walkers at once.
#pragma once

#include <string_view>

namespace pliant {

/// How walkers are resolved; the choice changes no result.
struct LaneOptions {
  bool lanes = true;            ///< false: one walker after the other
  std::string_view level = {};  ///< a name in lane_level_names(); the best one if empty
};

}  // namespace pliant
