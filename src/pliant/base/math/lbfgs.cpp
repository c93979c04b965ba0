// SPDX-License-Identifier: MIT
#include "pliant/base/math/lbfgs.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <utility>

namespace pliant {
namespace {

using Points = std::vector<Vec3>;

double inner(const Points& a, const Points& b) {
  double sum = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += dot(a[k], b[k]);
  return sum;
}

void add(double factor, const Points& from, Points& to) {
  for (std::size_t k = 0; k < to.size(); ++k) to[k] += factor * from[k];
}

Points difference(const Points& a, const Points& b) {
  Points out = a;
  add(-1.0, b, out);
  return out;
}

double largest(const Points& points) {
  double most = 0.0;
  for (const Vec3 p : points) most = std::max({most, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  return most;
}

/// A step that was made, and how it changed the gradient.
struct Pair {
  Points step, change;
  double product;  ///< of both, above 0
};

class Descent {
 public:
  Descent(const ValueAndGradient& function, Points& x, const MinimiseOptions& options)
      : function_(function), options_(options), x_(x), gradient_(x.size()) {
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

  /// Two loops over what is known of the curvature, from the gradient to the way down.
  Points way() const {
    Points out = gradient_;
    std::vector<double> shares;
    for (auto pair = known_.rbegin(); pair != known_.rend(); ++pair) {
      shares.push_back(inner(pair->step, out) / pair->product);
      add(-shares.back(), pair->change, out);
    }
    const double scale =
        known_.empty() ? 1.0 / std::max(1.0, largest(gradient_))
                       : known_.back().product / inner(known_.back().change, known_.back().change);
    for (Vec3& v : out) v *= -scale;
    for (const Pair& pair : known_) {
      const double share = inner(pair.change, out) / pair.product;
      add(-shares.back() - share, pair.step, out);
      shares.pop_back();
    }
    return out;
  }

  /// Shortens the step until it gains enough (Armijo). False where none gains.
  bool step() {
    constexpr double enough = 1e-4, most_shorter = 0.1, shortest = 1e-10;
    Points along = way();
    double slope = inner(gradient_, along);
    if (!(slope < 0.0)) {
      known_.clear();
      along = way();
      slope = inner(gradient_, along);
    }
    Points there(x_.size()), gradient(x_.size());
    for (double length = 1.0; length > shortest;) {
      there = x_;
      add(length, along, there);
      const double value = evaluate(there, gradient);
      if (value <= found_.value + enough * length * slope) return take(there, gradient, value);
      const double parabola = -0.5 * slope * length / ((value - found_.value) / length - slope);
      length *= std::isfinite(parabola) ? std::clamp(parabola / length, most_shorter, 0.5) : 0.1;
    }
    return false;
  }

  bool take(Points& there, Points& gradient, double value) {
    Pair made{difference(there, x_), difference(gradient, gradient_), 0.0};
    made.product = inner(made.step, made.change);
    // Without positive curvature the estimate would no longer be that of a minimum.
    if (made.product > 1e-12 * inner(made.change, made.change)) known_.push_back(std::move(made));
    if (known_.size() > options_.memory) known_.pop_front();
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
  std::deque<Pair> known_;
  Minimum found_;
};

}  // namespace

Minimum minimise(const ValueAndGradient& function, std::vector<Vec3>& x,
                 const MinimiseOptions& options) {
  return Descent(function, x, options).run();
}

}  // namespace pliant
