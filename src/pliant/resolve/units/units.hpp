// SPDX-License-Identifier: MIT
// Technique `units`: rigid units placed exactly in one outward pass, loops closed on their own.
//
// With bars across bond angles an atom and its neighbours are one rigid unit, and so are small
// rings; two units share a bond, about which they turn. FRODA (Wells et al., Phys. Biol. 2 (2005)
// S127) fits such units to the atoms and the atoms to the units in turn until they agree; where
// the units hang together as a tree one pass from unit to unit has them agree at once.
#pragma once

#include <memory>

#include "pliant/resolve/method/method.hpp"

namespace pliant {

/// Rings of up to six joints with drawn positions are held as drawn, also the few (cyclohexane's
/// boat) that special lengths leave flexible. Frameworks with no unit of three joints, and what the
/// pass leaves broken (loops that do not close, pinned joints in several units, impossible
/// lengths), are resolved as by technique `blocks`.
std::unique_ptr<Method> make_units(const Framework& framework, const Technique& technique,
                                   const ResolveOptions& options);

/// The same, and then all hinges turned at once so that the joints come as near as they can to
/// where they were: in one pass whatever hangs on a unit swings with it.
std::unique_ptr<Method> make_units_nearest(const Framework& framework, const Technique& technique,
                                           const ResolveOptions& options);

}  // namespace pliant
