// SPDX-License-Identifier: MIT
// Custom sweeps, a function in C++ or in Python, until all bars are whole.
#pragma once

#include <memory>

#include "pliant/resolve/method/method.hpp"

namespace pliant {

/// The method of a technique with a custom sweep (Technique::sweep).
std::unique_ptr<Method> make_custom_sweeps(const Framework& framework, const Technique& technique,
                                           const ResolveOptions& options);

}  // namespace pliant
