// SPDX-License-Identifier: MIT
#include "pliant/lab/examples/example_rows.hpp"

namespace pliant {
namespace {

constexpr auto ring_of_bodies = "ring of n hinged bodies: max(0, n - 6) flexes";

/// Ethane: C-C 1.54, C-H about 1.09 Angstrom; angle bars follow.
Sketch ethane() {
  return with_angles(spelled("ab ac ad ae bf bg bh", {{0, 0, 0},
                                                      {1.54, 0, 0},
                                                      {-0.36, 1.03, 0},
                                                      {-0.36, -0.515, 0.892},
                                                      {-0.36, -0.515, -0.892},
                                                      {1.9, 0.515, 0.892},
                                                      {1.9, -1.03, 0},
                                                      {1.9, 0.515, -0.892}}));
}

Sketch apart(Sketch one, const Sketch& other, Vec3 shift) {
  const auto first = static_cast<Joint>(one.positions.size());
  for (Vec3 x : other.positions) one.positions.push_back(x + shift);
  for (Bar bar : other.bars) one.bars.push_back({first + bar.a, first + bar.b});
  return one;
}

}  // namespace

std::vector<ExampleRow> family_examples() {
  return {
      {"no_joints", closed_form, {}, {.components = 0, .rank = 0}},
      {"chain_10",
       closed_form,
       chain(10),
       {.bridges = 9, .rank = 9, .rigid_motions = 6, .flexes = 15}},
      {"straight_chain_5",
       closed_form,
       straight_chain(5),
       {.bridges = 4, .rank = 4, .rigid_motions = 5}},
      {"ring_6",
       closed_form,
       ring(6),
       {.cycles = 1, .blocks = 1, .rank = 6, .rigid_motions = 6, .flexes = 6}},
      {"ring_17",
       closed_form,
       ring(17),
       {.cycles = 1, .blocks = 1, .rank = 17, .rigid_motions = 6, .flexes = 28}},
      {"star_7", closed_form, star(7), {.bridges = 7, .rank = 7, .rigid_motions = 6, .flexes = 11}},
      {"complete_7",
       "K_n: rank 3n - 6, (n - 3)(n - 4) / 2 stresses",
       complete(7),
       {.cycles = 15, .blocks = 1, .rank = 15, .rigid_motions = 6, .flexes = 0}},
      {"grid_5x5", closed_form, grid(5, 5), {.cycles = 25, .blocks = 1, .rank = 60}},
      {"chain_4_with_angles",
       "n - 3 torsions",
       shaken(with_angles(chain(4)), 0.1),
       {.cycles = 2, .blocks = 1, .rank = 5, .rigid_motions = 6, .flexes = 1}},
      {"chain_10_with_angles",
       "n - 3 torsions",
       shaken(with_angles(chain(10)), 0.1),
       {.cycles = 8, .blocks = 1, .rank = 17, .rigid_motions = 6, .flexes = 7}},
      {"ring_5_with_angles",
       "K5: one stress",
       shaken(with_angles(ring(5)), 0.1),
       {.cycles = 6, .blocks = 1, .rank = 9, .rigid_motions = 6, .flexes = 0}},
      {"ring_7_with_angles",
       ring_of_bodies,
       shaken(with_angles(ring(7)), 0.2),
       {.cycles = 8, .blocks = 1, .rank = 14, .rigid_motions = 6, .flexes = 1}},
      {"ring_8_with_angles",
       ring_of_bodies,
       shaken(with_angles(ring(8)), 0.2),
       {.cycles = 9, .blocks = 1, .rank = 16, .rigid_motions = 6, .flexes = 2}},
      {"ethane_with_angles",
       "two K5 sharing the C-C bar: rank 9 + 9 - 1",
       ethane(),
       {.cycles = 12, .blocks = 1, .rank = 17, .rigid_motions = 6, .flexes = 1}},
      {"ring_chain_and_star_apart",
       "sum of the parts, and 6 a part beyond the first",
       apart(apart(ring(5), chain(4), {9, 0, 0}), star(3), {0, 9, 0}),
       {.components = 3,
        .cycles = 1,
        .bridges = 6,
        .blocks = 1,
        .rank = 11,
        .rigid_motions = 6,
        .flexes = 22}},
  };
}

}  // namespace pliant
