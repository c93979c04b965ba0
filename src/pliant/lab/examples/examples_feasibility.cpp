// SPDX-License-Identifier: MIT
#include <numbers>

#include "pliant/lab/examples/example_rows.hpp"

namespace pliant {
namespace {

constexpr auto taut = "the longest is the sum of the others: flat, unique, singular";
constexpr auto open_by_d =
    "the longest exceeds the sum of the others by D: least squares D / n each";
constexpr ExampleFacts one_cycle{.cycles = 1, .blocks = 1, .whole = false};
constexpr ExampleFacts impossible_cycle{
    .cycles = 1, .blocks = 1, .feasible = false, .whole = false};
constexpr ExampleFacts one_tetrahedron{.cycles = 3, .blocks = 1, .whole = false};

Sketch triangle() { return spelled("ab bc ac", {{0, 0, 0}, {1, 0.5, 0}, {2, 0, 0.25}}); }
Sketch quadrilateral() {
  return spelled("ab bc cd da", {{0, 0, 0}, {1, 0.5, 0}, {2, 0.25, 0.5}, {3, 0, 0}});
}
Sketch pentagon() {
  return spelled("ab bc cd de ea",
                 {{0, 0, 0}, {1, 0.5, 0}, {2, 0.5, 0.5}, {3, 0.25, 0.25}, {4, 0, 0}});
}
Sketch tetrahedron() {
  return spelled("ab ac ad bc bd cd", {{0, 0, 0}, {1, 0, 0}, {0.5, 0.75, 0.25}, {0.5, -0.75, 0}});
}

/// Eleven joints in a zigzag between ends that are `span` apart.
Sketch between_pinned_ends(double span) {
  Sketch sketch = straight_chain(11);
  for (std::size_t i = 0; i < 11; ++i)
    sketch.positions[i] = {span * double(i) / 10.0, i % 2 == 1 ? 0.25 : 0.0, 0.0};
  return sketch;
}

ExampleRow pinned_ends(std::string_view name, double span, bool feasible) {
  return {name,
          closed_form,
          between_pinned_ends(span),
          {.bridges = 10, .feasible = feasible, .whole = false},
          std::vector<double>(10, 1.0),
          {},
          {0, 10}};
}

Sketch collapsed(Sketch sketch) {
  for (Vec3& x : sketch.positions) x = {1, 2, 3};
  return sketch;
}

}  // namespace

std::vector<ExampleRow> feasibility_examples() {
  return {
      {"triangle_1_1_3",
       "least squares: each bar off by 1/3",
       triangle(),
       impossible_cycle,
       {1, 1, 3}},
      {"triangle_1_2_3_taut", taut, triangle(), one_cycle, {1, 2, 3}},
      {"polygon_taut_1_1_1_3", taut, quadrilateral(), one_cycle, {1, 1, 1, 3}},
      {"polygon_taut_1_2_3_6", taut, quadrilateral(), one_cycle, {1, 2, 3, 6}},
      {"polygon_taut_1_1_1_1_4", taut, pentagon(), one_cycle, {1, 1, 1, 1, 4}},
      {"polygon_open_1_1_1_4", open_by_d, quadrilateral(), impossible_cycle, {1, 1, 1, 4}},
      {"polygon_open_1_2_3_7", open_by_d, quadrilateral(), impossible_cycle, {1, 2, 3, 7}},
      {"polygon_open_1_1_1_1_6", open_by_d, pentagon(), impossible_cycle, {1, 1, 1, 1, 6}},
      pinned_ends("pinned_ends_9_apart", 9.0, true),
      pinned_ends("pinned_ends_taut_10", 10.0, true),
      pinned_ends("pinned_ends_too_far_12", 12.0, false),
      {"pinned_pair_wrong_distance",
       closed_form,
       spelled("ab", {{0, 0, 0}, {2, 0, 0}}),
       {.bridges = 1, .feasible = false, .whole = false},
       {1},
       {},
       {0, 1}},
      {"K4_five_unit_bars_one_sqrt3",
       "two unit triangles on one edge, flat",
       tetrahedron(),
       one_tetrahedron,
       {1, 1, 1, 1, 1, std::numbers::sqrt3}},
      {"K4_five_unit_bars_one_1.8",
       "1.8 > sqrt(3): only the Cayley-Menger determinant tells",
       tetrahedron(),
       {.cycles = 3, .blocks = 1, .feasible = false, .whole = false},
       {1, 1, 1, 1, 1, 1.8}},
      {"K5_all_unit",
       "a regular simplex of five joints needs four dimensions",
       complete(5),
       {.cycles = 6, .blocks = 1, .feasible = false, .whole = false},
       std::vector<double>(10, 1.0)},
      {"coincident_pair", closed_form, collapsed(chain(2)), {.bridges = 1, .whole = false}, {1}},
      {"coincident_ring",
       closed_form,
       collapsed(ring(5)),
       {.cycles = 1, .blocks = 1, .whole = false},
       {1, 1, 1, 1, 1}},
      {"coincident_star",
       closed_form,
       collapsed(star(5)),
       {.bridges = 5, .whole = false},
       {1, 1, 1, 1, 1}},
  };
}

}  // namespace pliant
