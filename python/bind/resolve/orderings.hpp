// SPDX-License-Identifier: MIT
// Orderings in Python: tuples (bar, near, is_tree) of three arrays of equal length.
#pragma once

#include <nanobind/stl/tuple.h>

#include <memory>
#include <optional>
#include <tuple>

#include "arrays.hpp"
#include "pliant/order/ordering.hpp"

namespace pliant::python {

/// Bars, near joints, and whether the weighting divides the correction.
using OrderingColumns = std::tuple<ArrayLike, ArrayLike, ArrayLike>;

nb::tuple ordering_to_python(const Ordering& ordering);

/// Throws TypeError or InputError for invalid columns. Whether they fit a framework is checked
/// later.
Ordering ordering_from(const OrderingColumns& columns);

/// The value of Technique::ordering; null for None.
std::shared_ptr<const Ordering> technique_ordering(const std::optional<OrderingColumns>& columns);

}  // namespace pliant::python
