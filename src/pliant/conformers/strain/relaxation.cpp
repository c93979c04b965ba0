// SPDX-License-Identifier: MIT
#include "pliant/conformers/strain/relaxation.hpp"

#include <algorithm>
#include <cmath>

#include "pliant/base/math/lbfgs_memory.hpp"

namespace pliant {
namespace {

constexpr std::size_t memory = 6;
constexpr int halvings = 12;
constexpr double enough = 1e-4;  // of the decrease that the slope promises (Armijo)
constexpr double first_scale = 1e-3, least_curvature = 1e-10;

using Points = std::vector<Vec3>;

void shorten(Points& direction, double longest) {
  double square = 0.0;
  for (const Vec3& at : direction) square = std::max(square, norm_squared(at));
  if (square <= longest * longest) return;
  const double factor = longest / std::sqrt(square);
  for (Vec3& at : direction) at *= factor;
}

}  // namespace

double relax(const EnergyOf& energy, const RelaxationOptions& options, std::vector<Vec3>& x) {
  Points gradient(x.size()), next_gradient(x.size());
  double now = energy(x, gradient);
  LbfgsMemory kept(memory);
  const double least = options.least_gradient * options.least_gradient * double(x.size());
  for (int step = 0; step < options.steps && points::inner(gradient, gradient) > least; ++step) {
    Points direction = kept.direction(gradient, first_scale);
    double slope = points::inner(direction, gradient);
    if (!(slope < 0.0)) {
      if (kept.empty()) break;
      kept.forget();
      continue;
    }
    shorten(direction, options.longest_move);
    slope = points::inner(direction, gradient);
    double share = 1.0, there = HUGE_VAL;
    Points next;
    for (int k = 0; k < halvings; ++k, share *= 0.5) {
      next = x;
      points::add(share, direction, next);
      there = energy(next, next_gradient);
      if (there <= now + enough * share * slope) break;
      there = HUGE_VAL;
    }
    if (there == HUGE_VAL) {
      if (kept.empty()) break;
      kept.forget();
      continue;
    }
    kept.keep(points::difference(next, x), points::difference(next_gradient, gradient),
              least_curvature);
    x.swap(next);
    gradient.swap(next_gradient);
    now = there;
  }
  return now;
}

}  // namespace pliant
