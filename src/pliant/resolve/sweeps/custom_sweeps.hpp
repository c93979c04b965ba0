// SPDX-License-Identifier: MIT
// Sweeps that somebody else makes, a function in C++ or in Python, until all bars are whole.
#pragma once

#include <memory>

#include "pliant/resolve/method/method.hpp"

namespace pliant {

/// The method of a technique that has a sweep of its own (Technique::sweep).
std::unique_ptr<Method> make_custom_sweeps(const Framework& framework, const Technique& technique,
                                           const ResolveOptions& options);

}  // namespace pliant
