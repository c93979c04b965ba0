// SPDX-License-Identifier: MIT
#include "pliant/fit/map/spread_rotations.hpp"

#include <cmath>
#include <numbers>

#include "pliant/base/math/elementary.hpp"

namespace pliant {
namespace {

struct CosineSine {
  double cosine, sine;
};

/// Of a number of whole turns.
CosineSine of_turns(double turns) {
  const double angle = 2.0 * std::numbers::pi * (turns - std::floor(turns));
  return {exact_bits_cos(angle), exact_bits_cos(angle - std::numbers::pi / 2.0)};
}

Rotation rotation_of(double w, double x, double y, double z) {
  return {{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
          {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
          {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}};
}

}  // namespace

std::vector<Rotation> spread_rotations(std::size_t count) {
  // The positive root of x^4 = x + 4 and that of x^2 = 2 leave no two rotations near each other.
  constexpr double psi = 1.533751168755204288118041;
  std::vector<Rotation> out;
  out.reserve(count);
  for (std::size_t k = 0; k < count; ++k) {
    const double place = static_cast<double>(k) + 0.5;
    const double share = place / static_cast<double>(count);
    const CosineSine one = of_turns(place / std::numbers::sqrt2), other = of_turns(place / psi);
    const double r = std::sqrt(share), rest = std::sqrt(1.0 - share);
    out.push_back(
        rotation_of(r * one.sine, r * one.cosine, rest * other.sine, rest * other.cosine));
  }
  return out;
}

}  // namespace pliant
