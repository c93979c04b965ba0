// SPDX-License-Identifier: MIT
// Technique `froda`: rigid units are pulled by their torsions to where a push left their joints,
// and pushed apart until limits and sterics hold.
#pragma once

#include <memory>

#include "pliant/resolve/method/method.hpp"

namespace pliant {

/// Starts from the whole positions before the push (ResolveCall::reference), or, if these are not
/// known, from what `units` gives. Frameworks with pinned joints, in a plane or with
/// many loops of units are resolved as by `anderson`, and so is what it leaves broken.
std::unique_ptr<Method> make_froda(const Framework& framework, const Technique& technique,
                                   const ResolveOptions& options);

}  // namespace pliant
