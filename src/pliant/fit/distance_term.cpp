// SPDX-License-Identifier: MIT
#include "pliant/fit/distance_term.hpp"

#include <algorithm>
#include <cmath>

namespace pliant {
double outside(const FitDistance& datum, double distance) {
  return distance > datum.high ? distance - datum.high : std::min(0.0, distance - datum.low);
}

void DistanceTerm::begin(std::size_t stage, std::span<const Vec3> /*nodes*/) {
  weight_ = fit_weights[stage];
}

double DistanceTerm::add(std::span<const Vec3> nodes, std::span<Vec3> gradient) const {
  const std::vector<Vec3> places = sites_.places(nodes);
  std::vector<Vec3> slopes(places.size());
  double value = 0.0;
  for (const FitDistance& datum : data_) {
    const Vec3 between = places[datum.a] - places[datum.b];
    const double r = norm(between), u = outside(datum, r);
    if (u == 0.0) continue;
    value += weight_ * u * u;
    const Vec3 force = (2.0 * weight_ * u / std::max(r, 1e-9)) * between;
    slopes[datum.a] += force;
    slopes[datum.b] -= force;
  }
  sites_.add_gradient(nodes, slopes, gradient);
  return value;
}

}  // namespace pliant
