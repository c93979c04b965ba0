// SPDX-License-Identifier: MIT
// Bars that cannot hold together whatever the positions: triangles that break their inequality.
#pragma once

#include <string>
#include <vector>

#include "pliant/framework/framework.hpp"

namespace pliant {

/// For each triangle of bars whose longest bar exceeds the sum of the others (by more than
/// rounding) a sentence that names its three bars; at most `most` of them. O(B^1.5).
std::vector<std::string> impossible_triangles(const Framework& framework, std::size_t most = 10);

}  // namespace pliant
