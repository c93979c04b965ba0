// SPDX-License-Identifier: MIT
// Technique `units`: rigid units placed exactly in one outward pass, with loops closed separately.
//
// With bars across bond angles, an atom with its neighbours is a rigid unit, and so are small
// rings; two units share a bond, about which they turn. FRODA (Wells et al., Phys. Biol. 2 (2005)
// S127) alternately fits such units to the atoms and the atoms to the units until both agree; if
// the units form a tree, one pass from unit to unit gives agreement at once.
#pragma once

#include <memory>

#include "pliant/resolve/method/method.hpp"

namespace pliant {

/// Rings of up to six joints with drawn positions are held as drawn, also the few (cyclohexane's
/// boat) that special lengths leave flexible. Frameworks without a unit of three joints, and what
/// the pass leaves broken (loops that do not close, pinned joints in several units, impossible
/// lengths), are resolved by technique `blocks`.
std::unique_ptr<Method> make_units(const Framework& framework, const Technique& technique,
                                   const ResolveOptions& options);

}  // namespace pliant
