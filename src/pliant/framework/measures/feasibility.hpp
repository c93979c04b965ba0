// SPDX-License-Identifier: MIT
// Bars that no positions can satisfy: triangles that violate the triangle inequality.
#pragma once

#include <string>
#include <vector>

#include "pliant/framework/framework.hpp"

namespace pliant {

/// Returns a sentence for each triangle of bars whose longest bar exceeds the sum of the others by
/// more than rounding; it names the three bars. At most `most` sentences. O(B^1.5).
std::vector<std::string> impossible_triangles(const Framework& framework, std::size_t most = 10);

}  // namespace pliant
