// SPDX-License-Identifier: MIT
// The version comes from CMake's project() by a definition.
#include "pliant/base/version.hpp"

namespace pliant {

std::string_view version() { return PLIANT_VERSION; }

}  // namespace pliant
