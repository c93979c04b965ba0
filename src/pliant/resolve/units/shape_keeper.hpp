// SPDX-License-Identifier: MIT
// Has methods that know bars alone keep what those do not tell: on which side of its plane an atom
// of a flat group is. Units that come out with another shape get their own where they lie, and what
// that breaks is resolved again; where that bends them once more, `units_nearest` answers.
#pragma once

#include <memory>

#include "pliant/resolve/method/method.hpp"

namespace pliant {

/// Whether the framework has shapes that lengths do not tell from others: see KeptShapes.
bool has_shapes_to_keep(const Framework& framework, const ResolveOptions& options);

/// Technique `newton`, or `shake`, which keeps shapes where there are any. Reference positions tell
/// which units had lost theirs before the push; those are left as they are.
std::unique_ptr<Method> make_newton_in_shape(const Framework& framework, const Technique& technique,
                                             const ResolveOptions& options);
std::unique_ptr<Method> make_shake_in_shape(const Framework& framework, const Technique& technique,
                                            const ResolveOptions& options);

}  // namespace pliant
