// SPDX-License-Identifier: MIT
#include <cmath>

#include "pliant/lab/examples/example_rows.hpp"

namespace pliant {
namespace {}  // namespace

// Ranks are those of the plane, which are those of space too; flexes would differ.
std::vector<ExampleRow> planar_examples() {
  return {
      {"prism_2D_general",
       pyrigi,
       spelled("ab bc ac de ef df ad be cf",
               {{0, 0, 0}, {3, 0, 0}, {2, 1, 0}, {0, 4, 0}, {2, 4, 0}, {1, 3, 0}}),
       {.cycles = 4, .blocks = 1, .rank = 9}},
      {"prism_2D_parallel_desargues",
       pyrigi,
       spelled("ab bc ac de ef df ad be cf",
               {{0, 0, 0}, {2, 0, 0}, {1, 2, 0}, {0, 6, 0}, {2, 6, 0}, {1, 4, 0}}),
       {.cycles = 4, .blocks = 1, .rank = 8}},
      {"square_2D",
       pyrigi,
       spelled("ab bc cd ad", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}),
       {.cycles = 1, .blocks = 1, .rank = 4}},
      {"square_2D_one_diagonal",
       pyrigi,
       spelled("ab bc cd ad ac", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}),
       {.cycles = 2, .blocks = 1, .rank = 5}},
      {"square_2D_two_diagonals",
       "closed form: stresses +1 on sides, -1 on diagonals",
       spelled("ab ac ad bc bd cd", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}),
       {.cycles = 3, .blocks = 1, .rank = 5}},
      {"collapsed_parallelogram_2D",
       "branch point of the four-bar linkage",
       spelled("ab bc cd ad", {{0, 0, 0}, {2, 0, 0}, {3, 0, 0}, {1, 0, 0}}),
       {.cycles = 1, .blocks = 1, .rank = 3}},
      {"K33_2D_general",
       pyrigi,
       spelled("ad ae af bd be bf cd ce cf",
               {{0, 0, 0}, {5, 1, 0}, {2, 7, 0}, {1, 3, 0}, {6, 5, 0}, {-3, 2, 0}}),
       {.cycles = 4, .blocks = 1, .rank = 9}},
      {"K33_2D_dixon_I",
       pyrigi,
       spelled("ad ae af bd be bf cd ce cf",
               {{0, 1, 0}, {0, -2, 0}, {0, 3, 0}, {-1, 0, 0}, {2, 0, 0}, {-3, 0, 0}}),
       {.cycles = 4, .blocks = 1, .rank = 8}},
      {"square_grid_2D_2x3_cells",
       "Bolker, Crapo 1977: m + n - 1",
       spelled("ab bc cd ef fg gh ij jk kl ae bf cg dh ei fj gk hl", {{0, 0, 0},
                                                                      {1, 0, 0},
                                                                      {2, 0, 0},
                                                                      {3, 0, 0},
                                                                      {0, 1, 0},
                                                                      {1, 1, 0},
                                                                      {2, 1, 0},
                                                                      {3, 1, 0},
                                                                      {0, 2, 0},
                                                                      {1, 2, 0},
                                                                      {2, 2, 0},
                                                                      {3, 2, 0}}),
       {.cycles = 6, .blocks = 1, .rank = 17}},
      {"peaucellier_cell_2D",
       "|OB| |OD| = 5^2 - 3^2 in the plane",
       spelled("ab ac bd cd be ce", {{0, 0, 0},
                                     {4.1, std::sqrt(8.19), 0},
                                     {4.1, -std::sqrt(8.19), 0},
                                     {3.2, 0, 0},
                                     {5, 0, 0}}),
       {.cycles = 2, .blocks = 1, .rank = 6}},
  };
}

}  // namespace pliant
