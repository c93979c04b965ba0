// SPDX-License-Identifier: MIT
// Orderings as Python sees them: tuples (bar, near, is_tree) of three arrays of one length.
#pragma once

#include <nanobind/stl/tuple.h>

#include <memory>
#include <optional>
#include <tuple>

#include "arrays.hpp"
#include "pliant/order/ordering.hpp"

namespace pliant::python {

/// Bars, near joints, and whether the weighting shares the correction.
using OrderingColumns = std::tuple<ArrayLike, ArrayLike, ArrayLike>;

nb::tuple ordering_to_python(const Ordering& ordering);

/// Throws TypeError or InputError for columns that are none; whether they fit a framework is
/// checked where it is known.
Ordering ordering_from(const OrderingColumns& columns);

/// What Technique::ordering holds; null for None.
std::shared_ptr<const Ordering> technique_ordering(const std::optional<OrderingColumns>& columns);

}  // namespace pliant::python
