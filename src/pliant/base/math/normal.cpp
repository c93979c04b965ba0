// SPDX-License-Identifier: MIT
#include "pliant/base/math/normal.hpp"

#include <array>
#include <cmath>

#include "pliant/base/math/elementary.hpp"

namespace pliant {

void fill_normal(RandomSequence& draws, std::span<double> out) {
  for (std::size_t k = 0; k < out.size(); k += 2) {
    double u = 0.0, v = 0.0, s = 0.0;
    do {
      u = 2.0 * draws.uniform() - 1.0;
      v = 2.0 * draws.uniform() - 1.0;
      s = u * u + v * v;
    } while (!(s < 1.0 && s > 1e-300));
    const double scale = std::sqrt(-2.0 * exact_bits_log(s) / s);
    out[k] = u * scale;
    if (k + 1 < out.size()) out[k + 1] = v * scale;
  }
}

Vec3 normal_vector(RandomSequence& draws) {
  std::array<double, 3> x{};
  fill_normal(draws, x);
  return {x[0], x[1], x[2]};
}

}  // namespace pliant
