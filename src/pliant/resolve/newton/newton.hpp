// SPDX-License-Identifier: MIT
// Technique `newton`: finds the whole positions nearest to the broken ones in mass-weighted
// distance.
#pragma once

#include <memory>

#include "pliant/resolve/method/method.hpp"

namespace pliant {

std::unique_ptr<Method> make_newton(const Framework& framework, const Technique& technique,
                                    const ResolveOptions& options);

}  // namespace pliant
