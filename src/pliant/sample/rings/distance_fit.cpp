// SPDX-License-Identifier: MIT
#include "pliant/sample/rings/distance_fit.hpp"

#include <algorithm>
#include <cmath>

#include "pliant/resolve/units/dense_solve.hpp"

namespace pliant {
namespace {

constexpr int most_steps = 60;
constexpr double closed = 1e-13;  // of a squared distance
// Equations may depend on each other, as the twelve of flexible boats do: a little is added.
constexpr double damping = 1e-9;

}  // namespace

double approach(const std::vector<WantedDistance>& wanted, double damped, std::vector<Vec3>& x) {
  const std::size_t n = wanted.size();
  std::vector<double> off(n), product(n * n, 0.0);
  double worst = 0.0, largest = 0.0;
  for (std::size_t a = 0; a < n; ++a) {
    off[a] = norm_squared(x[wanted[a].i] - x[wanted[a].j]) - wanted[a].square;
    worst = std::max(worst, std::abs(off[a]) / wanted[a].square);
  }
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = 0; b <= a; ++b) {
      const auto& [i, j, one] = wanted[a];
      const auto& [k, l, other] = wanted[b];
      const double shared =
          (i == k ? 1.0 : 0.0) + (j == l ? 1.0 : 0.0) - (i == l ? 1.0 : 0.0) - (j == k ? 1.0 : 0.0);
      product[a * n + b] = 4.0 * shared * dot(x[i] - x[j], x[k] - x[l]);
      largest = std::max(largest, product[a * n + b]);
    }
  for (std::size_t a = 0; a < n; ++a) product[a * n + a] += damped * largest;
  if (!solve_positive(product, off, 0.0)) return HUGE_VAL;
  const std::vector<Vec3> old = x;
  for (std::size_t a = 0; a < n; ++a) {
    const Vec3 along = (2.0 * off[a]) * (old[wanted[a].i] - old[wanted[a].j]);
    x[wanted[a].i] += -1.0 * along;
    x[wanted[a].j] += along;
  }
  return worst;
}

bool meet(const std::vector<WantedDistance>& wanted, std::vector<Vec3>& x) {
  double worst = HUGE_VAL;
  for (int step = 0; step < most_steps && worst > closed; ++step)
    worst = approach(wanted, damping, x);
  return worst <= closed;
}

}  // namespace pliant
