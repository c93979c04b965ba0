// SPDX-License-Identifier: MIT
// Sweeps of an ordering (nonlinear Gauss-Seidel; as SHAKE visits its constraints, one after
// another, each seeing the effect of earlier ones).
#pragma once

#include <memory>

#include "pliant/resolve/method/method.hpp"

namespace pliant {

/// The method of every technique that is an ordering; see Technique.
std::unique_ptr<Method> make_sweeps(const Framework& framework, const Technique& technique,
                                    const ResolveOptions& options);

}  // namespace pliant
