// SPDX-License-Identifier: MIT
// Taut chains: whether a joint is as far from another as the bars between them let it.
#pragma once

#include <optional>
#include <span>

#include "pliant/framework/framework.hpp"
#include "pliant/run/held_pull.hpp"

namespace pliant {

/// The longest chain of bonds from `joint` whose ends are as far apart as they can be with its
/// angles as they are now (all bonds trans), to within a twentieth, and that lies along the pull.
/// None if it has fewer than six bonds. A joint without a bar to the next but one turns freely:
/// there the chain may be straight.
std::optional<TautChain> find_taut_chain(const Framework& framework,
                                         std::span<const Vec3> positions, Joint joint, Vec3 along);

}  // namespace pliant
