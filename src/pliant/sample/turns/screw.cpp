// SPDX-License-Identifier: MIT
#include "pliant/sample/turns/screw.hpp"

#include <array>

#include "pliant/base/math/best_fit.hpp"

namespace pliant {
namespace {

constexpr double flat = 1e-6;  // of the inertia: nodes on a line do not tell a turn about it

struct Means {
  Vec3 place, move;
};

Means means_of(std::span<const Vec3> nodes, std::span<const Vec3> moves,
               std::span<const std::uint32_t> of_node, std::uint32_t part) {
  Means sums;
  double count = 0.0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (of_node[i] != part) continue;
    sums.place += nodes[i];
    sums.move += moves[i];
    count += 1.0;
  }
  const double share = count > 0.0 ? 1.0 / count : 0.0;
  return {share * sums.place, share * sums.move};
}

/// Inertia^-1 torque, along axes that have an inertia.
Vec3 turn_by(std::array<double, 9> inertia, Vec3 torque) {
  std::array<double, 9> vectors{};
  find_eigenvectors(inertia, vectors, 3);
  const double least = flat * (inertia[0] + inertia[4] + inertia[8]);
  Vec3 turn;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 axis{vectors[k], vectors[3 + k], vectors[6 + k]};
    if (inertia[4 * k] > least) turn += (dot(axis, torque) / inertia[4 * k]) * axis;
  }
  return turn;
}

}  // namespace

Screw screw_of(std::span<const Vec3> nodes, std::span<const Vec3> moves,
               std::span<const std::uint32_t> of_node, std::uint32_t part) {
  const Means mean = means_of(nodes, moves, of_node, part);
  std::array<double, 9> inertia{};
  Vec3 torque;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (of_node[i] != part) continue;
    const Vec3 r = nodes[i] - mean.place;
    torque += cross(r, moves[i] - mean.move);
    const std::array<double, 3> x{r.x, r.y, r.z};
    for (std::size_t a = 0; a < 3; ++a) {
      inertia[4 * a] += norm_squared(r);
      for (std::size_t b = 0; b < 3; ++b) inertia[3 * a + b] -= x[a] * x[b];
    }
  }
  const Vec3 turn = turn_by(inertia, torque);
  return {turn, mean.move - cross(turn, mean.place)};
}

}  // namespace pliant
