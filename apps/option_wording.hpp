// SPDX-License-Identifier: MIT
// How errors of the command line call what they expected.
#pragma once

#include <cstdint>
#include <string>

#include "pliant/base/range.hpp"

namespace pliant::app {

/// "a whole number from 1 to 8".
std::string wording(std::int64_t least, std::int64_t most);

/// "a number above 0".
std::string wording(Range range);

}  // namespace pliant::app
