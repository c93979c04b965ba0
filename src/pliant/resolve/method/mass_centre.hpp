// SPDX-License-Identifier: MIT
// Keeps the centre of mass where a method that goes outward does not.
#pragma once

#include <memory>

#include "pliant/resolve/method/method.hpp"

namespace pliant {

/// A method that does as `method`, and then shifts every component without pinned joints so that its
/// centre of mass is where it was before: no force from outside acts on it. Looks at all joints.
std::unique_ptr<Method> keep_mass_centre(const Framework& framework,
                                         std::unique_ptr<Method> method);

}  // namespace pliant
