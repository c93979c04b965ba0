// SPDX-License-Identifier: MIT
#include "pliant/base/math/lbfgs.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "pliant/base/math/lbfgs_memory.hpp"

namespace pliant {
namespace {

using Points = std::vector<Vec3>;

double largest(const Points& points) {
  double most = 0.0;
  for (const Vec3 p : points) most = std::max({most, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  return most;
}

class Descent {
 public:
  Descent(const ValueAndGradient& function, Points& x, const MinimiseOptions& options)
      : function_(function), options_(options), x_(x), gradient_(x.size()), known_(options.memory) {
    found_.value = evaluate(x_, gradient_);
  }

  Minimum run() {
    for (std::size_t k = 0; k < options_.steps && !found_.has_converged; ++k) {
      if (largest(gradient_) <= options_.tolerance || !step()) found_.has_converged = true;
    }
    return found_;
  }

 private:
  double evaluate(const Points& x, Points& gradient) {
    ++found_.evaluations;
    return function_(x, gradient);
  }

  Points way() const {
    return known_.direction(gradient_, 1.0 / std::max(1.0, largest(gradient_)));
  }

  /// Shortens the step until it gains enough (Armijo). False where none gains.
  bool step() {
    constexpr double enough = 1e-4, most_shorter = 0.1, shortest = 1e-10;
    Points along = way();
    double slope = points::inner(gradient_, along);
    if (!(slope < 0.0)) {
      known_.forget();
      along = way();
      slope = points::inner(gradient_, along);
    }
    Points there(x_.size()), gradient(x_.size());
    for (double length = 1.0; length > shortest;) {
      there = x_;
      points::add(length, along, there);
      const double value = evaluate(there, gradient);
      if (value <= found_.value + enough * length * slope) return take(there, gradient, value);
      const double parabola = -0.5 * slope * length / ((value - found_.value) / length - slope);
      length *= std::isfinite(parabola) ? std::clamp(parabola / length, most_shorter, 0.5) : 0.1;
    }
    return false;
  }

  bool take(Points& there, Points& gradient, double value) {
    Points change = points::difference(gradient, gradient_);
    const double least = 1e-12 * points::inner(change, change);
    known_.keep(points::difference(there, x_), std::move(change), least);
    const double gain = found_.value - value;
    x_.swap(there);
    gradient_.swap(gradient);
    found_.value = value;
    return gain > options_.least_gain * std::max(1.0, std::abs(value));
  }

  const ValueAndGradient& function_;
  const MinimiseOptions& options_;
  Points& x_;
  Points gradient_;
  LbfgsMemory known_;
  Minimum found_;
};

}  // namespace

Minimum minimise(const ValueAndGradient& function, std::vector<Vec3>& x,
                 const MinimiseOptions& options) {
  return Descent(function, x, options).run();
}

}  // namespace pliant
