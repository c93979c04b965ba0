// SPDX-License-Identifier: MIT
// Checks that positions can carry a framework: they are finite, and not so far from the origin that
// rounding swallows the bars.
#pragma once

#include <span>

#include "pliant/base/log.hpp"
#include "pliant/framework/measures/residual.hpp"

namespace pliant {

/// Throws InputError if there are not N positions, if one is not finite or beyond 1e150 Angstrom,
/// or if the spacing of doubles there is no smaller than the shortest bar. Warns if the spacing
/// alone exceeds the tolerance of the shortest bar, so that it cannot be met.
void check_positions(const Framework& framework, std::span<const Vec3> positions,
                     const Tolerance& tolerance, const Log& log);

}  // namespace pliant
