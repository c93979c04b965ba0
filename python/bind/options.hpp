// SPDX-License-Identifier: MIT
// Options that several calls share, as keyword arguments with the library's own defaults.
#pragma once

#include <optional>

#include "bind.hpp"
#include "pliant/resolve/resolve.hpp"
#include "resolve/orderings.hpp"
#include "resolve/techniques.hpp"

namespace pliant::python {

inline Tolerance tolerance_from(double relative, std::optional<double> length) {
  return {relative, length.value_or(0.0)};
}

/// The keyword arguments that choose a technique and its limits, in this order.
struct ResolveArguments {
  TechniqueLike technique;
  double weighting;
  bool mass_weighted;
  double tolerance;
  std::optional<double> tolerance_length;
  double tolerance_limit;
  double tolerance_overlap;
  std::int64_t max_sweeps;
  std::uint64_t seed;
  std::uint64_t walker;
  std::optional<OrderingColumns> ordering;

  Technique chosen(const Framework& framework) const {
    Technique asked{{}, weighting, mass_weighted, technique_ordering(ordering)};
    choose(asked, technique);
    show_framework(asked, framework);
    return asked;
  }
  ResolveOptions options() const {
    ResolveOptions options;
    options.tolerance = {tolerance, tolerance_length.value_or(0.0), tolerance_limit,
                         tolerance_overlap};
    options.max_sweeps = max_sweeps;
    options.seed = seed;
    options.walker = walker;
    return options;
  }
};

}  // namespace pliant::python
