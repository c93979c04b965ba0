// SPDX-License-Identifier: MIT
// Breadth-first and depth-first traversals of the joints that list the bars they visit. Neighbours
// are visited in the order of the bars in the input. Components that the root does not reach
// follow, each from its lowest joint. Linear in joints + bars, never recursive.
#pragma once

#include "pliant/order/ordering.hpp"

namespace pliant {

/// Breadth-first (level by level). When a joint is taken from the queue, first its tree bars are
/// listed, then the non-tree bars whose other end was taken earlier: the rule that prints every
/// breadth-first figure of the thesis (2.2, 5.2, 5.5, 5.8, 5.10).
void traverse_breadth_first(const Framework& framework, Joint root, bool with_non_tree_bars,
                            OrderScratch& scratch, Ordering& out);

/// Depth-first. A non-tree bar is listed as soon as it is met.
void traverse_depth_first(const Framework& framework, Joint root, bool with_non_tree_bars,
                          OrderScratch& scratch, Ordering& out);

}  // namespace pliant
