// SPDX-License-Identifier: MIT
// Steps of rigid units that cost only what a push disturbs.
#pragma once

#include <memory>

#include "pliant/resolve/method/method.hpp"

namespace pliant {

/// Techniques `units` and `froda`. If few joints were pushed and the positions before the push are
/// known, only a region around them is resolved, and larger ones where it holds them back; the
/// whole framework where that does not suffice.
std::unique_ptr<Method> make_local_units(const Framework& framework, const Technique& technique,
                                         const ResolveOptions& options);
std::unique_ptr<Method> make_local_froda(const Framework& framework, const Technique& technique,
                                         const ResolveOptions& options);

}  // namespace pliant
