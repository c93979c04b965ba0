// SPDX-License-Identifier: MIT
#include "pliant/conformers/torsions/small_sterics.hpp"

#include <cmath>

namespace pliant {
namespace {

constexpr std::size_t most_joints = 300;

}  // namespace

SmallSterics::SmallSterics(const Framework& framework) {
  if (framework.sterics() == nullptr || framework.joint_count() > most_joints) return;
  const LeastDistances rules(framework);
  for (Joint a = 0; a < framework.joint_count(); ++a)
    for (Joint b = a + 1; b < framework.joint_count(); ++b)
      if (const double least = rules.of(a, b); least > 0.0) pairs_.push_back({a, b, least});
}

double SmallSterics::overlap(std::span<const Vec3> x, double enough) const {
  double sum = 0.0;
  for (const NeighbourPair& pair : pairs_) {
    const double square = norm_squared(x[pair.a] - x[pair.b]);
    if (square >= pair.least * pair.least) continue;
    const double depth = pair.least - std::sqrt(square);
    sum += depth * depth;
    if (sum >= enough) break;
  }
  return sum;
}

}  // namespace pliant
