// SPDX-License-Identifier: MIT
// The sequence in which bars are eliminated when the equations of all are solved at once
// (fill-reducing ordering of the Gram matrix of the bars, whose graph is the line graph).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "pliant/resolve/equations/bar_pattern.hpp"

namespace pliant {

/// The bars as indices into `ends`. Bars of trees come first, leaves before their parents, which
/// causes no fill; those on and between rings follow by approximate minimum degree (Amestoy, Davis,
/// Duff, SIAM J. Matrix Anal. 17 (1996) 886). Linear in the bars and the pairs of bars that share a
/// joint.
std::vector<std::uint32_t> elimination_order(std::span<const EquationEnds> ends,
                                             std::size_t joint_count);

}  // namespace pliant
