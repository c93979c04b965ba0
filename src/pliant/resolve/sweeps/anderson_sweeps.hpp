// SPDX-License-Identifier: MIT
// Technique `anderson`: sweeps of `bfs_cycle`, accelerated, for any framework.
#pragma once

#include <memory>

#include "pliant/resolve/method/method.hpp"

namespace pliant {

std::unique_ptr<Method> make_anderson(const Framework& framework, const Technique& technique,
                                      const ResolveOptions& options);

}  // namespace pliant
