// SPDX-License-Identifier: MIT
// Validates orderings, for tests and debug builds.
#pragma once

#include <string>

#include "pliant/order/ordering.hpp"

namespace pliant {

/// What an ordering promises beyond visiting each bar at most once, from one of its ends.
struct OrderingPromise {
  bool all_bars = true;   ///< no bar is left out
  bool tree_bars = true;  ///< bars marked as tree bars form a forest
};

/// Says what is wrong with `ordering` as an ordering of `framework`; "" if nothing is.
std::string check_ordering(const Framework& framework, const Ordering& ordering,
                           const OrderingPromise& promise = {});

}  // namespace pliant
