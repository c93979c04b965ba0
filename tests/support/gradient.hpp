// SPDX-License-Identifier: MIT
// Gradients of terms of fits by finite differences.
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "pliant/fit/fit_term.hpp"

namespace pliant::test {

/// Each component by central differences.
inline void expect_gradient(const FitTerm& term, std::vector<Vec3> x, double tolerance = 1e-4) {
  std::vector<Vec3> gradient(x.size()), unused(x.size());
  term.add(x, gradient);
  constexpr double h = 1e-5;
  for (std::size_t k = 0; k < x.size(); ++k)
    for (double Vec3::*axis : {&Vec3::x, &Vec3::y, &Vec3::z}) {
      const double before = x[k].*axis;
      x[k].*axis = before + h;
      const double above = term.add(x, unused);
      x[k].*axis = before - h;
      const double below = term.add(x, unused);
      x[k].*axis = before;
      EXPECT_NEAR(gradient[k].*axis, (above - below) / (2 * h), tolerance);
    }
}

}  // namespace pliant::test
