// SPDX-License-Identifier: MIT
#include "pliant/fit/map/density_term.hpp"

#include <utility>

namespace pliant {

DensityTerm::DensityTerm(DensityMap map)
    : map_(std::make_shared<const DensityMap>(std::move(map))) {}

double DensityTerm::add(std::span<const Vec3> x, double weight, std::span<Vec3> gradient) const {
  double sum = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    const DensityAt found = map_->at(x[k]);
    sum += found.value;
    gradient[k] -= weight * found.gradient;
  }
  return -weight * sum;
}

}  // namespace pliant
