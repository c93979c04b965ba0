// SPDX-License-Identifier: MIT
// Technique `froda`: rigid units pulled to where a push left their joints, by their torsions, and
// out of each other until limits and sterics hold.
#pragma once

#include <memory>

#include "pliant/resolve/method/method.hpp"

namespace pliant {

/// Begins where the bars were whole before the push (ResolveCall::reference), or if that is not
/// known at what `units_nearest` makes of the positions. Frameworks with pinned joints, of the
/// plane or with many loops of units, and what it leaves broken, are resolved as by `anderson`.
std::unique_ptr<Method> make_froda(const Framework& framework, const Technique& technique,
                                   const ResolveOptions& options);

}  // namespace pliant
