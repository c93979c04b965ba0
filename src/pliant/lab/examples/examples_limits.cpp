// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>

#include "pliant/lab/examples/example_rows.hpp"

namespace pliant {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

/// Three struts of one length between two triangles, the upper turned by 150 degrees: the one turn
/// at which cables along the triangles and from corner to corner hold them (Connelly, Whiteley,
/// SIAM J. Discrete Math. 9 (1996) 453). Joints 0, 1, 2 are the lower triangle.
std::vector<Vec3> prism_corners() {
  std::vector<Vec3> corners;
  for (int level = 0; level < 2; ++level)
    for (int k = 0; k < 3; ++k) {
      const double angle = std::numbers::pi * (2.0 * k / 3.0 + level * 5.0 / 6.0);
      corners.push_back({std::cos(angle), std::sin(angle), 2.0 * level});
    }
  return corners;
}

Limit cable(const std::vector<Vec3>& at, Joint a, Joint b) {
  return {.a = a, .b = b, .most = distance(at[a], at[b])};
}

ExampleRow tensegrity_prism() {
  ExampleRow row{"tensegrity_prism",
                 "Connelly, Whiteley 1996: three struts, nine cables",
                 {prism_corners(), {{0, 3}, {1, 4}, {2, 5}}},
                 {.components = 3, .bridges = 3, .rank = 3, .rigid_motions = 6, .flexes = 9}};
  const auto& at = row.sketch.positions;
  for (Joint k = 0; k < 3; ++k) {
    row.limits.push_back(cable(at, k, (k + 1) % 3));
    row.limits.push_back(cable(at, 3 + k, 3 + (k + 1) % 3));
    row.limits.push_back(cable(at, k, 3 + (k + 2) % 3));
  }
  return row;
}

/// The ends of a straight chain of four unit bars may not come nearer than 3.
ExampleRow chain_with_strut() {
  ExampleRow row{"chain_5_with_strut", "closed form", straight_chain(5), {.bridges = 4}};
  row.limits.push_back({.a = 0, .b = 4, .least = 3.0, .most = unbounded});
  return row;
}

/// A staircase whose ends a cable must draw together, from sqrt(8) to 2.
ExampleRow chain_with_tight_cable() {
  ExampleRow row{
      "chain_5_with_tight_cable", "closed form", chain(5), {.bridges = 4, .whole = false}};
  row.limits.push_back({.a = 0, .b = 4, .most = 2.0});
  return row;
}

/// 3 x 3 x 3 spheres of diameter 1.2, a distance of 1 apart: each overlaps its neighbours.
ExampleRow spheres() {
  ExampleRow row{"spheres_27",
                 "closed form",
                 {},
                 {.components = 27, .whole = false, .rank = 0, .rigid_motions = 6}};
  for (int z = 0; z < 3; ++z)
    for (int y = 0; y < 3; ++y)
      for (int x = 0; x < 3; ++x) row.sketch.positions.push_back({double(x), double(y), double(z)});
  auto sterics = std::make_shared<Sterics>();
  sterics->kind_count = 1;
  sterics->kinds.assign(27, 0);
  sterics->least = {1.2};
  row.sterics = std::move(sterics);
  return row;
}

}  // namespace

std::vector<ExampleRow> limit_examples() {
  return {tensegrity_prism(), chain_with_strut(), chain_with_tight_cable(), spheres()};
}

}  // namespace pliant
