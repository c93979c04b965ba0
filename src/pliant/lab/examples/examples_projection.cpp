// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>

#include "pliant/lab/examples/example_rows.hpp"

namespace pliant {
namespace {

constexpr auto gromacs =
    "GROMACS 2022, src/gromacs/mdlib/tests/constr.cpp: joints, masses, lengths";
constexpr auto openmm = "OpenMM, tests/TestVerletIntegrator.h: joints, masses, lengths";

}  // namespace

std::vector<ExampleRow> projection_examples() {
  constexpr double leg = 0.1 * std::numbers::sqrt2 / 2.0;
  const double third = 0.2 / std::sqrt(3.0);
  return {
      {"gmx_one_constraint_OH",
       gromacs,
       spelled("ab", {{0, leg, 0}, {leg, 0, 0}}),
       {.bridges = 1, .rank = 1, .rigid_motions = 5, .flexes = 0},
       {0.1},
       {1, 12}},
      {"gmx_two_disjoint",
       gromacs,
       spelled("ab cd",
               {{2.5, -3.1, 15.7}, {0.51, -3.02, 15.55}, {-0.5, -3, 15.2}, {-1.51, -2.95, 15.05}}),
       {.components = 2, .bridges = 2, .whole = false, .rank = 2, .rigid_motions = 6, .flexes = 4},
       {2, 1},
       {0.5, 1.0 / 3.0, 0.25, 1}},
      {"gmx_three_atoms_chain_CH2",
       gromacs,
       spelled("ab bc", {{leg, leg, 0}, {0, 0, 0}, {third, third, third}}),
       {.bridges = 2, .rank = 2, .rigid_motions = 6, .flexes = 1},
       {0.1, 0.2},
       {1, 12, 16}},
      {"gmx_triangle",
       gromacs,
       spelled("ab ac bc", {{leg, 0, 0}, {0, leg, 0}, {0, 0, leg}}),
       {.cycles = 1, .blocks = 1, .rank = 3, .rigid_motions = 6, .flexes = 0},
       {0.1, 0.1, 0.1},
       {1, 1, 1}},
      {"openmm_staircase",
       openmm,
       spelled("ab bc cd ef gh", {{0, 0, 0},
                                  {0, 1, 0},
                                  {1, 1, 0},
                                  {1, 2, 0},
                                  {2, 2, 0},
                                  {2, 3, 0},
                                  {3, 3, 0},
                                  {3, 4, 0}}),
       {.components = 3, .bridges = 5, .rank = 5, .rigid_motions = 6, .flexes = 13},
       {},
       {5, 10, 5, 10, 5, 10, 5, 10}},
      {"openmm_settle_water",
       "OpenMM, tests/TestSettle.h: joints, masses, lengths",
       spelled("ab ac bc", {{0, 0, 0}, {0.1, 0, 0}, {-0.03333, 0.09428, 0}}),
       {.cycles = 1, .blocks = 1, .whole = false, .rank = 3, .rigid_motions = 6, .flexes = 0},
       {0.1, 0.1, 0.163},
       {16, 1, 1}},
  };
}

}  // namespace pliant
