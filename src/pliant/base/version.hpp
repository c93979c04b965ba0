// SPDX-License-Identifier: MIT
// Version of the library that is linked in.
#pragma once

#include <string_view>

namespace pliant {

/// "major.minor.patch", as CMakeLists.txt gives it.
std::string_view version();

}  // namespace pliant
