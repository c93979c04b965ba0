// SPDX-License-Identifier: MIT
#include "pliant/conformers/rings/distance_fit.hpp"

#include <algorithm>
#include <cmath>

#include "pliant/base/math/dense_solve.hpp"

namespace pliant {
namespace {

constexpr int most_steps = 60;
constexpr double closed = 1e-13;  // of a squared distance
// Equations may depend on each other, as the twelve of flexible boats do: a little is added.
constexpr double damping = 1e-9;

}  // namespace

namespace {

/// Squared distances, their errors and their gradients.
struct Equations {
  const std::vector<WantedDistance>& wanted;
  std::vector<double> off;
  std::vector<Vec3> apart;  ///< half of the gradient at i

  Equations(const std::vector<WantedDistance>& all, const std::vector<Vec3>& x)
      : wanted(all), off(all.size()), apart(all.size()) {
    for (std::size_t a = 0; a < all.size(); ++a) {
      apart[a] = x[all[a].i] - x[all[a].j];
      off[a] = norm_squared(apart[a]) - all[a].square;
    }
  }
  double worst() const {
    double worst = 0.0;
    for (std::size_t a = 0; a < off.size(); ++a)
      worst = std::max(worst, std::abs(off[a]) / wanted[a].square);
    return worst;
  }
};

/// The step of least change, by an equation for each distance.
bool step_by_distances(const Equations& equations, double damped, std::vector<Vec3>& x) {
  const auto& wanted = equations.wanted;
  const std::size_t n = wanted.size();
  std::vector<double> product(n * n, 0.0), off = equations.off;
  double largest = 0.0;
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = 0; b <= a; ++b) {
      const auto& [i, j, one] = wanted[a];
      const auto& [k, l, other] = wanted[b];
      const double shared =
          (i == k ? 1.0 : 0.0) + (j == l ? 1.0 : 0.0) - (i == l ? 1.0 : 0.0) - (j == k ? 1.0 : 0.0);
      product[a * n + b] = 4.0 * shared * dot(equations.apart[a], equations.apart[b]);
      largest = std::max(largest, product[a * n + b]);
    }
  for (std::size_t a = 0; a < n; ++a) product[a * n + a] += damped * largest;
  if (!solve_positive(product, off, 0.0)) return false;
  for (std::size_t a = 0; a < n; ++a) {
    const Vec3 along = (2.0 * off[a]) * equations.apart[a];
    x[wanted[a].i] -= along;
    x[wanted[a].j] += along;
  }
  return true;
}

/// The same step by an equation for each coordinate: (J'J + d) s = J'r is J' (JJ' + d)^-1 r.
bool step_by_places(const Equations& equations, double damped, std::vector<Vec3>& x) {
  const auto& wanted = equations.wanted;
  const std::size_t n = 3 * x.size();
  std::vector<double> product(n * n, 0.0), right(n, 0.0);
  double largest = 0.0;
  for (std::size_t a = 0; a < wanted.size(); ++a) {
    const Vec3 half = equations.apart[a];
    const double at[3] = {2.0 * half.x, 2.0 * half.y, 2.0 * half.z};
    largest = std::max(largest, 8.0 * norm_squared(half));
    const std::size_t low = 3 * std::min(wanted[a].i, wanted[a].j);
    const std::size_t high = 3 * std::max(wanted[a].i, wanted[a].j);
    for (std::size_t p = 0; p < 3; ++p) {
      right[3 * wanted[a].i + p] += at[p] * equations.off[a];
      right[3 * wanted[a].j + p] -= at[p] * equations.off[a];
      for (std::size_t q = 0; q < 3; ++q) {
        if (q <= p) product[(low + p) * n + low + q] += at[p] * at[q];
        if (q <= p) product[(high + p) * n + high + q] += at[p] * at[q];
        product[(high + p) * n + low + q] -= at[p] * at[q];
      }
    }
  }
  for (std::size_t k = 0; k < n; ++k) product[k * n + k] += damped * largest;
  if (!solve_positive(product, right, 0.0)) return false;
  for (std::size_t k = 0; k < x.size(); ++k)
    x[k] -= Vec3{right[3 * k], right[3 * k + 1], right[3 * k + 2]};
  return true;
}

}  // namespace

double approach(const std::vector<WantedDistance>& wanted, double damped, std::vector<Vec3>& x) {
  const Equations equations(wanted, x);
  const double worst = equations.worst();
  const bool has_many = wanted.size() > 3 * x.size();
  const bool is_solved =
      has_many ? step_by_places(equations, damped, x) : step_by_distances(equations, damped, x);
  return is_solved ? worst : HUGE_VAL;
}

bool meet(const std::vector<WantedDistance>& wanted, std::vector<Vec3>& x) {
  double worst = HUGE_VAL;
  for (int step = 0; step < most_steps && worst > closed; ++step)
    worst = approach(wanted, damping, x);
  return worst <= closed;
}

}  // namespace pliant
