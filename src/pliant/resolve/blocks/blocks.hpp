// SPDX-License-Identifier: MIT
// Technique `blocks`: bridges exact in one outward pass, every block (ring system) alone by Newton.
//
// The bridges and blocks of a graph hang together as a tree. Going outward from the root, a bridge
// is made whole by moving its far end alone, which breaks nothing that was made whole before; a
// block is made whole with the joint by which it is entered held still, which breaks nothing
// either. One pass therefore resolves any molecule of chains and rings.
#pragma once

#include <memory>

#include "pliant/resolve/method/method.hpp"

namespace pliant {

std::unique_ptr<Method> make_blocks(const Framework& framework, const Technique& technique,
                                    const ResolveOptions& options);

}  // namespace pliant
