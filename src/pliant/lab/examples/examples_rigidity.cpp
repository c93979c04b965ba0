// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>

#include "pliant/lab/examples/example_rows.hpp"

namespace pliant {
namespace {

Vec3 on_circle(double radius, double degrees, double z) {
  const double angle = degrees * std::numbers::pi / 180.0;
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

/// Two hexagons, each braced and coned to a rigid body, and as many legs between them.
Sketch stewart_gough(std::string_view bars) {
  std::vector<Vec3> positions;
  for (double degrees : {-14.0, 74.0, 106.0, 194.0, 226.0, 314.0})
    positions.push_back(on_circle(2.0, degrees, 0.0));
  for (double degrees : {8.0, 112.0, 128.0, 232.0, 248.0, 352.0})
    positions.push_back(on_circle(1.0, degrees, 1.5));
  positions.insert(positions.end(), {{0, 0, -1}, {0, 0, 2.5}});
  return spelled(bars, positions);
}

/// Two equal parallel triangles, one turned, joined as an octahedron.
Sketch platform(double twist) {
  std::vector<Vec3> positions;
  for (double degrees : {0.0, 120.0, 240.0}) positions.push_back(on_circle(1.0, degrees, 0.0));
  for (double degrees : {0.0, 120.0, 240.0})
    positions.push_back(on_circle(1.0, degrees + twist, 1.0));
  return spelled("ab bc ca de ef fd ad be cf af bd ce", positions);
}

/// The 12 even permutations of (0, +-1, +-golden ratio), joined at distance 2.
Sketch icosahedron() {
  Sketch sketch;
  for (double a : {-1.0, 1.0})
    for (double b : {-std::numbers::phi, std::numbers::phi})
      for (Vec3 x : {Vec3{0, a, b}, Vec3{b, 0, a}, Vec3{a, b, 0}}) sketch.positions.push_back(x);
  for (Joint k = 0; k < 12; ++k)
    for (Joint i = 0; i < k; ++i)
      if (distance(sketch.positions[i], sketch.positions[k]) < 2.1) sketch.bars.push_back({i, k});
  return sketch;
}

constexpr auto two_bodies =
    "ab bc cd de ef fa ac ce ea gh hi ij jk kl lg gi ik kg ma mb mc md me mf ng nh ni nj nk nl";
constexpr auto two_bodies_and_legs =
    "ab bc cd de ef fa ac ce ea gh hi ij jk kl lg gi ik kg ma mb mc md me mf ng nh ni nj nk nl "
    "ag bh ci dj ek fl";

}  // namespace

std::vector<ExampleRow> rigidity_examples() {
  return {
      {"one_joint",
       closed_form,
       spelled("", {{0, 0, 0}}),
       {.rank = 0, .rigid_motions = 3, .flexes = 0}},
      {"two_joints_no_bar",
       closed_form,
       spelled("", {{0, 0, 0}, {1, 0, 0}}),
       {.components = 2, .rank = 0, .rigid_motions = 5, .flexes = 1}},
      {"one_bar",
       closed_form,
       spelled("ab", {{0, 0, 0}, {1, 0, 0}}),
       {.bridges = 1, .rank = 1, .rigid_motions = 5, .flexes = 0}},
      {"two_coincident_joints_no_bar",
       closed_form,
       spelled("", {{1, 2, 3}, {1, 2, 3}}),
       {.components = 2, .rank = 0, .rigid_motions = 3}},
      {"bent_path_3",
       closed_form,
       spelled("ab bc", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}),
       {.bridges = 2, .rank = 2, .rigid_motions = 6, .flexes = 1}},
      {"straight_path_3",
       closed_form,
       spelled("ab bc", {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}),
       {.bridges = 2, .rank = 2, .rigid_motions = 5, .flexes = 1}},
      {"triangle_3_4_5",
       closed_form,
       spelled("ab ac bc", {{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}),
       {.cycles = 1, .blocks = 1, .rank = 3, .rigid_motions = 6, .flexes = 0}},
      {"collinear_triangle_1_1_2",
       pyrigi,
       spelled("ab ac bc", {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}),
       {.cycles = 1, .blocks = 1, .rank = 2, .rigid_motions = 5, .flexes = 0}},
      {"two_triangles_sharing_a_joint",
       closed_form,
       spelled("ab ac bc ad ae de", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 1}, {0, -1, 1}}),
       {.cycles = 2, .blocks = 2, .rank = 6, .rigid_motions = 6, .flexes = 3}},
      {"two_triangles_sharing_an_edge",
       closed_form,
       spelled("ab ac bc ad bd", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}),
       {.cycles = 2, .blocks = 1, .rank = 5, .rigid_motions = 6, .flexes = 1}},
      {"two_tetrahedra_sharing_an_edge",
       "body-hinge count",
       spelled("ab ac ad bc bd cd ae af be bf ef",
               {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, -1, 0}, {0, -1, 2}}),
       {.cycles = 6, .blocks = 1, .rank = 11, .rigid_motions = 6, .flexes = 1}},
      {"tetrahedron_K4",
       pyrigi,
       spelled("ab ac ad bc bd cd", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}),
       {.cycles = 3, .blocks = 1, .rank = 6, .rigid_motions = 6, .flexes = 0}},
      {"K5",
       closed_form,
       spelled("ab ac ad ae bc bd be cd ce de",
               {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 2, 3}}),
       {.cycles = 6, .blocks = 1, .rank = 9, .rigid_motions = 6, .flexes = 0}},
      {"octahedron_int",
       pyrigi,
       spelled("ac ad ae af bc bd be bf ce cf de df",
               {{0, 0, -1}, {0, 0, 1}, {-1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}}),
       {.cycles = 7, .blocks = 1, .rank = 12, .rigid_motions = 6, .flexes = 0}},
      {"bricard_octahedron_line_symmetric",
       pyrigi,
       spelled("ac ad ae af bc bd be bf ce cf de df",
               {{1, 0, 0}, {-1, 0, 0}, {1, 2, 1}, {-1, -2, 1}, {2, -1, -1}, {-2, 1, -1}}),
       {.cycles = 7, .blocks = 1, .rank = 11, .rigid_motions = 6, .flexes = 1}},
      {"cube_edges",
       pyrigi,
       spelled("ab bc cd ad ef fg gh eh ae bf cg dh", {{0, 0, 0},
                                                       {1, 0, 0},
                                                       {1, 1, 0},
                                                       {0, 1, 0},
                                                       {0, 0, 1},
                                                       {1, 0, 1},
                                                       {1, 1, 1},
                                                       {0, 1, 1}}),
       {.cycles = 5, .blocks = 1, .rank = 12, .rigid_motions = 6, .flexes = 6}},
      {"cube_with_one_diagonal_per_face",
       "Dehn: triangulated convex surface",
       spelled("ab bc cd ad ef fg gh eh ae bf cg dh ac eg af ch ah cf", {{0, 0, 0},
                                                                         {1, 0, 0},
                                                                         {1, 1, 0},
                                                                         {0, 1, 0},
                                                                         {0, 0, 1},
                                                                         {1, 0, 1},
                                                                         {1, 1, 1},
                                                                         {0, 1, 1}}),
       {.cycles = 11, .blocks = 1, .rank = 18, .rigid_motions = 6, .flexes = 0}},
      {"double_banana_generic",
       pyrigi,
       spelled("ac ad ae af ag ah bc bd be bf bg bh cd ce de fg fh gh", {{-66, 56, -68},
                                                                         {15, -38, -17},
                                                                         {-81, 86, -95},
                                                                         {-70, 83, -7},
                                                                         {-62, 19, -4},
                                                                         {7, 10, 56},
                                                                         {47, 44, 28},
                                                                         {-27, 35, -69}}),
       {.cycles = 11, .blocks = 1, .rank = 17, .rigid_motions = 6, .flexes = 1}},
      {"K_4_6_generic",
       "Bolker, Roth 1980; rank exact modulo two primes",
       spelled("ae af ag ah ai aj be bf bg bh bi bj ce cf cg ch ci cj de df dg dh di dj",
               {{-32, 48, -10},
                {91, 29, 88},
                {-91, 56, 0},
                {-88, 52, -61},
                {38, 18, 28},
                {-96, -73, 40},
                {-11, -29, 50},
                {-90, 41, -68},
                {-89, -51, -95},
                {-93, 38, 0}}),
       {.cycles = 15, .blocks = 1, .rank = 24, .rigid_motions = 6, .flexes = 0}},
      {"K_4_5_generic",
       "rank exact modulo two primes",
       spelled("ae af ag ah ai be bf bg bh bi ce cf cg ch ci de df dg dh di", {{52, -49, -54},
                                                                               {6, 43, -12},
                                                                               {-17, -31, 42},
                                                                               {74, 7, -81},
                                                                               {25, 56, -42},
                                                                               {-45, 37, -40},
                                                                               {69, 36, 4},
                                                                               {31, 18, -84},
                                                                               {80, -48, 58}}),
       {.cycles = 12, .blocks = 1, .rank = 20, .rigid_motions = 6, .flexes = 1}},
      {"three_connected_R3_circuit_generic",
       pyrigi,
       spelled("ab ac ad af ag ai aj al am bc bd be bk bl bm cd ce de ef eg eh fg fh gh hi hj hk "
               "ij ik jk kl km lm",
               {{77, -48, 54},
                {11, 21, -54},
                {22, -60, 91},
                {-42, -50, -92},
                {-74, 52, -79},
                {-7, -46, 64},
                {-59, 82, -2},
                {-51, 79, -4},
                {-19, -31, 81},
                {-70, -96, 20},
                {0, -44, 36},
                {-11, 31, -16},
                {65, 31, 93}}),
       {.cycles = 21, .blocks = 1, .rank = 32, .rigid_motions = 6, .flexes = 1}},
      {"second_order_rigid_connelly_whiteley",
       pyrigi,
       spelled("ab ac ad af ag bc be bg cd ce de df ef eg fg",
               {{0, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 0}}),
       {.cycles = 9, .blocks = 1, .rank = 13, .rigid_motions = 6, .flexes = 0}},
      {"stewart_gough_6_6_generic",
       "coned hexagons, 36 = 3 * 14 - 6 bars",
       stewart_gough(two_bodies_and_legs),
       {.cycles = 23, .blocks = 1, .rank = 36, .rigid_motions = 6, .flexes = 0}},
      {"stewart_gough_no_legs",
       "two rigid bodies",
       stewart_gough(two_bodies),
       {.components = 2, .cycles = 18, .blocks = 2, .rank = 30, .rigid_motions = 6, .flexes = 6}},
      {"octahedral_platform_twist_60",
       closed_form,
       platform(60),
       {.cycles = 7, .blocks = 1, .rank = 12, .rigid_motions = 6, .flexes = 0}},
      {"tensegrity_prism_twist_150",
       "singular at 150 and 330 degrees only",
       platform(150),
       {.cycles = 7, .blocks = 1, .rank = 11, .rigid_motions = 6, .flexes = 0}},
      {"icosahedron",
       "Dehn: triangulated convex surface",
       icosahedron(),
       {.cycles = 19, .blocks = 1, .rank = 30, .rigid_motions = 6, .flexes = 0}},
      {"cyclohexane_chair",
       "bond 3, 1-3 distance sqrt(24); rigid",
       spelled("ab bc cd de ef fa ac bd ce df ea fb",
               {{2 * std::numbers::sqrt2, 0, -0.5},
                {std::numbers::sqrt2, std::sqrt(6.0), 0.5},
                {-std::numbers::sqrt2, std::sqrt(6.0), -0.5},
                {-2 * std::numbers::sqrt2, 0, 0.5},
                {-std::numbers::sqrt2, -std::sqrt(6.0), -0.5},
                {std::numbers::sqrt2, -std::sqrt(6.0), 0.5}}),
       {.cycles = 7, .blocks = 1, .rank = 12, .rigid_motions = 6, .flexes = 0}},
      {"cyclohexane_boat",
       "the bars of the chair; moves",
       spelled("ab bc cd de ef fa ac bd ce df ea fb", {{-2.5, 0, std::numbers::sqrt2},
                                                       {-1.5, std::sqrt(6.0), 0},
                                                       {1.5, std::sqrt(6.0), 0},
                                                       {2.5, 0, std::numbers::sqrt2},
                                                       {1.5, -std::sqrt(6.0), 0},
                                                       {-1.5, -std::sqrt(6.0), 0}}),
       {.cycles = 7, .blocks = 1, .rank = 11, .rigid_motions = 6, .flexes = 1}},
  };
}

}  // namespace pliant
