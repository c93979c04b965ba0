// SPDX-License-Identifier: MIT
// Technique `blocks`: bridges exactly in one outward pass, and each block (ring system) by Newton's
// method.
//
// The bridges and blocks of a graph form a tree. Going outward from the root, a bridge is made
// whole by moving its far end alone, and a block with the joint of its entry held fixed. Neither
// breaks bars that were made whole before, so that one pass resolves any molecule of chains and
// rings.
#pragma once

#include <memory>

#include "pliant/resolve/method/method.hpp"

namespace pliant {

std::unique_ptr<Method> make_blocks(const Framework& framework, const Technique& technique,
                                    const ResolveOptions& options);

}  // namespace pliant
