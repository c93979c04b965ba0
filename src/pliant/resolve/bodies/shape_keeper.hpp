// SPDX-License-Identifier: MIT
// Makes methods that know only bars keep what lengths do not determine: the side of its plane on
// which an atom of a flat group is. Units that lose their shape are given it back where they are,
// and the bars that this breaks are resolved again; if that bends them once more, `froda` places
// them.
#pragma once

#include <memory>

#include "pliant/resolve/method/method.hpp"

namespace pliant {

/// Technique `newton`, or `shake`, that keeps shapes where there are any. Units that had lost
/// theirs already at the reference positions are not changed.
std::unique_ptr<Method> make_newton_in_shape(const Framework& framework, const Technique& technique,
                                             const ResolveOptions& options);
std::unique_ptr<Method> make_shake_in_shape(const Framework& framework, const Technique& technique,
                                            const ResolveOptions& options);

}  // namespace pliant
