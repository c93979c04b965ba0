// SPDX-License-Identifier: MIT
// Restores the centre of mass after methods that go outward.
#pragma once

#include <memory>

#include "pliant/resolve/method/method.hpp"

namespace pliant {

/// Returns a method that does as `method`, and then shifts every component without pinned joints so
/// that its centre of mass is where it was before, as without external forces. Visits all joints.
std::unique_ptr<Method> keep_mass_centre(const Framework& framework,
                                         std::unique_ptr<Method> method);

}  // namespace pliant
