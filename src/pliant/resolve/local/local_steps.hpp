// SPDX-License-Identifier: MIT
// Steps of rigid units that cost only what a push disturbs.
#pragma once

#include <memory>

#include "pliant/resolve/method/method.hpp"

namespace pliant {

/// Techniques `units` and `units_nearest`. If few joints were pushed and the positions before the push
/// are known, only the region around them is resolved; else, and where that does not suffice, the
/// whole framework.
std::unique_ptr<Method> make_local_units(const Framework& framework, const Technique& technique,
                                         const ResolveOptions& options);
std::unique_ptr<Method> make_local_units_nearest(const Framework& framework,
                                                 const Technique& technique,
                                                 const ResolveOptions& options);

}  // namespace pliant
