// SPDX-License-Identifier: MIT
// Technique `bfs_local`: sweeps of the disturbed region only.
#pragma once

#include <memory>

#include "pliant/resolve/method/method.hpp"

namespace pliant {

/// After a push of few joints: sweeps breadth first from them, out to where nothing has moved. A
/// bar that is whole is left alone, so the cost is that of the region which the push disturbs,
/// however large the framework. Where all joints may have moved: `bfs_cycle`, bar by bar.
std::unique_ptr<Method> make_local_sweeps(const Framework& framework, const Technique& technique,
                                          const ResolveOptions& options);

}  // namespace pliant
