// SPDX-License-Identifier: MIT
// Techniques that sweep only what must be swept, or sweep faster.
//
// `rings_first`: a bar on no cycle (a bridge) can always be made whole by moving all that hangs
// behind it, so only ring systems (blocks) are swept, each on its own positions and until it is
// whole. In the sweep in which the last one becomes whole one outward pass from the root (from the
// pinned joint, where there is one) puts everything together: the far end of a bridge is projected,
// and a ring system is carried along without being turned or bent. A tree takes one sweep.
// `rings_anderson`: the same with Anderson acceleration in each ring system.
// `anderson`: sweeps of `bfs_cycle`, accelerated, for any framework.
//
// In a component with several pinned joints nothing can be carried: all of its bars are swept.
// Limits and sterics tie what hangs behind a bridge to the rest: if one is violated once all bars
// are whole, sweeps of all bars with all limits follow.
#pragma once

#include <memory>

#include "pliant/resolve/method/method.hpp"

namespace pliant {

std::unique_ptr<Method> make_anderson(const Framework& framework, const Technique& technique,
                                      const ResolveOptions& options);
std::unique_ptr<Method> make_rings_first(const Framework& framework, const Technique& technique,
                                         const ResolveOptions& options);
std::unique_ptr<Method> make_rings_anderson(const Framework& framework, const Technique& technique,
                                            const ResolveOptions& options);

}  // namespace pliant
