// SPDX-License-Identifier: MIT
#include "pliant/conformers/torsions/loop_equations.hpp"

#include <gtest/gtest.h>

namespace pliant {
namespace loop_equations_test {

/// Place 2 lies 2 Angstrom from the axis of the hinge, which is z; it turns towards y.
const std::vector<Vec3> places{{0, 0, -1}, {0, 0, 1}, {2, 0, 0}};
const LoopHinge hinge{0, 1, 2, 3};

/// The turn that is least of damping d^2 + weight (off + slope d)^2.
double closed_form(double off, double slope, double weight, double damping) {
  return -weight * slope * off / (weight * slope * slope + damping);
}

TEST(LoopEquations, OneHingeTurnsByTheClosedForm) {
  LoopEquations equations({&hinge, 1});
  equations.begin(places, 0.5);
  equations.begin_row();
  equations.add_to_row(2, {0, 3, 7});  // the slope is 2 * 3: what points along z turns nothing
  equations.end_row(0.1, 4.0);
  const auto turns = equations.solve();
  ASSERT_EQ(turns.size(), 1U);
  EXPECT_NEAR(turns[0], closed_form(0.1, 6.0, 4.0, 0.5), 1e-15);
}

TEST(LoopEquations, RowsAddUpAndWhatDoesNotTurnDoesNotCount) {
  LoopEquations equations({&hinge, 1});
  equations.begin(places, 1.0);
  for (int k = 0; k < 3; ++k) {
    equations.begin_row();
    equations.add_to_row(2, {0, 1, 0});
    equations.end_row(0.2, 1.0);
  }
  equations.begin_row();
  equations.add_to_row(0, {5, 5, 5});
  equations.end_row(9.0, 9.0);
  EXPECT_NEAR(equations.solve()[0], closed_form(0.2, 2.0, 3.0, 1.0), 1e-15);
}

TEST(LoopEquations, DampingGrowsByAShareOfTheDiagonal) {
  LoopEquations equations({&hinge, 1});
  equations.begin(places, 0.0);
  equations.begin_row();
  equations.add_to_row(2, {0, 1, 0});
  equations.end_row(1.0, 1.0);
  equations.add_damping(0.25);  // of 4
  EXPECT_NEAR(equations.solve()[0], closed_form(1.0, 2.0, 1.0, 1.0), 1e-15);
}

TEST(LoopEquations, ThereIsNoSolutionWithoutRowsOrDamping) {
  LoopEquations equations({&hinge, 1});
  equations.begin(places, 0.0);
  EXPECT_TRUE(equations.solve().empty());
}

}  // namespace loop_equations_test
}  // namespace pliant
