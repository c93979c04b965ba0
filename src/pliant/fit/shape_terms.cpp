// SPDX-License-Identifier: MIT
#include "pliant/fit/shape_terms.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "pliant/base/math/cell_list.hpp"

namespace pliant {
namespace {

constexpr double spring_reach = 10.0;  // Angstrom
constexpr std::array along_chain{100.0, 30.0, 10.0};
constexpr std::uint32_t most_rigid = 4;   // residues apart
constexpr double giving_way = 2.0 * 2.0;  // Angstrom^2
constexpr double least_distance = 4.0;    // Angstrom
constexpr double steric_constant = 10.0;
constexpr double steric_reach = 9.0;        // Angstrom: of the list, as nodes move meanwhile
constexpr std::uint32_t least_between = 4;  // residues

double constant_of(std::uint32_t between, double length) {
  if (between <= along_chain.size()) return along_chain[between - 1];
  const double ratio = 6.0 / std::max(length, least_distance);
  return ratio * ratio * ratio * ratio * ratio * ratio;
}

/// Adds the gradient of a function of the distance r of two nodes, whose derivative is `slope`.
void pull(std::span<Vec3> gradient, std::uint32_t i, std::uint32_t j, Vec3 between, double r,
          double slope) {
  const Vec3 force = (slope / std::max(r, 1e-9)) * between;
  gradient[i] += force;
  gradient[j] -= force;
}

}  // namespace

std::uint32_t residues_between(const FitNodes& nodes, std::uint32_t i, std::uint32_t j) {
  constexpr std::uint32_t far = ~std::uint32_t{0};
  return nodes.chain[i] == nodes.chain[j] ? std::max(i, j) - std::min(i, j) : far;
}

SpringTerm::SpringTerm(const FitNodes& nodes) {
  CellList(nodes.positions, spring_reach)
      .for_each_pair([&](std::uint32_t i, std::uint32_t j, double squared) {
        const std::uint32_t between = residues_between(nodes, i, j);
        const double length = std::sqrt(squared);
        springs_.push_back({i, j, length, constant_of(between, length), between > most_rigid});
      });
}

double SpringTerm::add(std::span<const Vec3> nodes, std::span<Vec3> gradient) const {
  double value = 0.0;
  for (const Spring& spring : springs_) {
    const Vec3 between = nodes[spring.i] - nodes[spring.j];
    const double r = norm(between), u = r - spring.length;
    const bool gives_way = spring.gives_way && u > 0.0;
    const double left = gives_way ? giving_way / (giving_way + u * u) : 1.0;
    value += spring.constant * left * u * u;
    pull(gradient, spring.i, spring.j, between, r, 2.0 * spring.constant * left * left * u);
  }
  return value;
}

void StericTerm::begin(std::size_t /*stage*/, std::span<const Vec3> nodes) {
  near_.clear();
  CellList(nodes, steric_reach).for_each_pair([&](std::uint32_t i, std::uint32_t j, double) {
    if (residues_between(start_, i, j) >= least_between) near_.emplace_back(i, j);
  });
}

double StericTerm::add(std::span<const Vec3> nodes, std::span<Vec3> gradient) const {
  double value = 0.0;
  for (const auto& [i, j] : near_) {
    const Vec3 between = nodes[i] - nodes[j];
    const double squared = norm_squared(between);
    if (squared >= least_distance * least_distance) continue;
    const double r = std::sqrt(squared), u = r - least_distance;
    value += steric_constant * u * u;
    pull(gradient, i, j, between, r, 2.0 * steric_constant * u);
  }
  return value;
}

}  // namespace pliant
