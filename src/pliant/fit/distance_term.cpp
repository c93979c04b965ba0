// SPDX-License-Identifier: MIT
#include "pliant/fit/distance_term.hpp"

#include <algorithm>

#include "pliant/base/math/elementary.hpp"

namespace pliant {
namespace {

/// (sum of r^-6)^(-1/6)
template <class Apart>
double sixth_power_mean(std::span<const FitDistance> same, const Apart& apart) {
  double sum = 0.0;
  for (const FitDistance& one : same) {
    const double r = std::max(apart(one), 1e-9);
    sum += 1.0 / (r * r * r * r * r * r);
  }
  return exact_bits_exp(exact_bits_log(sum) / -6.0);
}

double seventh_power(double x) { return x * x * x * x * x * x * x; }

}  // namespace

double outside(const FitDistance& datum, double distance) {
  return distance > datum.high ? distance - datum.high : std::min(0.0, distance - datum.low);
}

void DistanceTerm::begin(std::size_t stage, std::span<const Vec3> /*nodes*/) {
  weight_ = fit_weights[stage];
}

/// Of a datum, which may be of any of the sites of `same`.
double DistanceTerm::add_one(std::span<const FitDistance> same, std::span<const Vec3> places,
                             std::span<Vec3> slopes) const {
  const auto apart = [&](const FitDistance& one) { return distance(places[one.a], places[one.b]); };
  const double r = same.size() == 1 ? apart(same[0]) : sixth_power_mean(same, apart);
  const double u = outside(same[0], r);
  if (u == 0.0) return 0.0;
  for (const FitDistance& one : same) {
    const Vec3 between = places[one.a] - places[one.b];
    const double length = norm(between);
    const double share = same.size() == 1 ? 1.0 : seventh_power(r / std::max(length, 1e-9));
    const Vec3 force = (2.0 * weight_ * u * share / std::max(length, 1e-9)) * between;
    slopes[one.a] += force;
    slopes[one.b] -= force;
  }
  return weight_ * u * u;
}

double DistanceTerm::add(std::span<const Vec3> nodes, std::span<Vec3> gradient) const {
  const std::vector<Vec3> places = sites_.places(nodes);
  std::vector<Vec3> slopes(places.size());
  double value = 0.0;
  for (std::size_t k = 0; k < data_.size(); k += 1 + data_[k].more)
    value += add_one(data_.subspan(k, 1 + data_[k].more), places, slopes);
  sites_.add_gradient(nodes, slopes, gradient);
  return value;
}

}  // namespace pliant
