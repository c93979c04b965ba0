// SPDX-License-Identifier: MIT
#include "pliant/conformers/strain/relaxation.hpp"

#include <algorithm>
#include <cmath>
#include <deque>

namespace pliant {
namespace {

constexpr std::size_t memory = 6;
constexpr int halvings = 12;
constexpr double enough = 1e-4;  // of the decrease that the slope promises (Armijo)

using Points = std::vector<Vec3>;

double product(const Points& a, const Points& b) {
  double sum = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += dot(a[k], b[k]);
  return sum;
}

void add(double factor, const Points& from, Points& to) {
  for (std::size_t k = 0; k < to.size(); ++k) to[k] += factor * from[k];
}

Points difference(const Points& a, const Points& b) {
  Points d = a;
  add(-1.0, b, d);
  return d;
}

/// Steps and changes of the gradient, the latest last.
class Memory {
 public:
  void keep(Points step, Points change) {
    const double curvature = product(step, change);
    if (!(curvature > 1e-10)) return;
    pairs_.push_back({std::move(step), std::move(change), curvature});
    if (pairs_.size() > memory) pairs_.pop_front();
  }

  /// The two loops over them: minus the inverse Hessian times the gradient.
  Points direction(const Points& gradient) const {
    Points d = gradient;
    std::vector<double> share(pairs_.size());
    for (std::size_t k = pairs_.size(); k-- > 0;) {
      share[k] = product(pairs_[k].step, d) / pairs_[k].curvature;
      add(-share[k], pairs_[k].change, d);
    }
    const double scale = pairs_.empty() ? 1e-3
                                        : pairs_.back().curvature /
                                              product(pairs_.back().change, pairs_.back().change);
    for (Vec3& at : d) at *= scale;
    for (std::size_t k = 0; k < pairs_.size(); ++k)
      add(share[k] - product(pairs_[k].change, d) / pairs_[k].curvature, pairs_[k].step, d);
    for (Vec3& at : d) at = -at;
    return d;
  }

  void forget() { pairs_.clear(); }
  bool empty() const { return pairs_.empty(); }

 private:
  struct Kept {
    Points step, change;
    double curvature;
  };
  std::deque<Kept> pairs_;
};

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
  Memory kept;
  const double least = options.least_gradient * options.least_gradient * double(x.size());
  for (int step = 0; step < options.steps && product(gradient, gradient) > least; ++step) {
    Points direction = kept.direction(gradient);
    double slope = product(direction, gradient);
    if (!(slope < 0.0)) {
      if (kept.empty()) break;
      kept.forget();
      continue;
    }
    shorten(direction, options.longest_move);
    slope = product(direction, gradient);
    double share = 1.0, there = HUGE_VAL;
    Points next;
    for (int k = 0; k < halvings; ++k, share *= 0.5) {
      next = x;
      add(share, direction, next);
      there = energy(next, next_gradient);
      if (there <= now + enough * share * slope) break;
      there = HUGE_VAL;
    }
    if (there == HUGE_VAL) {
      if (kept.empty()) break;
      kept.forget();
      continue;
    }
    kept.keep(difference(next, x), difference(next_gradient, gradient));
    x.swap(next);
    gradient.swap(next_gradient);
    now = there;
  }
  return now;
}

}  // namespace pliant
