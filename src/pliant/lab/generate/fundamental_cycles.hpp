// SPDX-License-Identifier: MIT
// Fundamental cycles: for each bar outside a breadth-first forest, the cycle that it closes.
#pragma once

#include <vector>

#include "pliant/framework/framework.hpp"

namespace pliant {

/// One cycle for each non-tree bar of a breadth-first forest (roots: the lowest joint of each
/// component), as the joints along it. Linear in joints + bars + length of the cycles.
std::vector<std::vector<Joint>> fundamental_cycles(const Framework& framework);

}  // namespace pliant
