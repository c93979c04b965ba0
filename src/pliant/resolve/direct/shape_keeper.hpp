// SPDX-License-Identifier: MIT
// Has a method that knows bars alone keep what they do not tell: on which side of its plane an atom
// of a flat group is. Units that come out with another shape get their own where they lie, and what
// that breaks is resolved again.
#pragma once

#include <memory>

#include "pliant/resolve/method/method.hpp"

namespace pliant {

/// Whether the framework has shapes that lengths do not tell from others: see KeptShapes.
bool has_shapes_to_keep(const Framework& framework, const ResolveOptions& options);

/// The method itself where there is nothing to keep. Reference positions tell which units had lost
/// their shape before the push; those are left as they are.
std::unique_ptr<Method> keep_shapes(const Framework& framework, const ResolveOptions& options,
                                    std::unique_ptr<Method> method);

}  // namespace pliant
