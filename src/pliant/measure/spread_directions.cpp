// SPDX-License-Identifier: MIT
#include "pliant/measure/spread_directions.hpp"

#include <cmath>
#include <numbers>

#include "pliant/base/math/elementary.hpp"

namespace pliant {

std::vector<Vec3> spread_directions(std::size_t count) {
  std::vector<Vec3> found(count);
  for (std::size_t k = 0; k < count; ++k) {
    const double turn = static_cast<double>(k) + 0.5;
    const double z = 1.0 - 2.0 * turn / static_cast<double>(count);
    const double r = std::sqrt(1.0 - z * z);
    const double angle =
        std::remainder(std::numbers::pi * (1.0 + std::sqrt(5.0)) * turn, 2.0 * std::numbers::pi);
    found[k] = {r * exact_bits_cos(angle), r * exact_bits_cos(angle - std::numbers::pi / 2.0), z};
  }
  return found;
}

}  // namespace pliant
