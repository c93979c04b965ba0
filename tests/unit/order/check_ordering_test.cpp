// SPDX-License-Identifier: MIT
#include "pliant/order/check_ordering.hpp"

#include <gtest/gtest.h>

#include "pliant/lab/examples/examples.hpp"

namespace pliant {
namespace check_ordering_test {

/// Bars 0 - 1, 1 - 2, 2 - 0.
const Framework& triangle() {
  static const Framework framework = framework_of(ring(3));
  return framework;
}

TEST(CheckOrdering, AcceptsATreeAndItsNonTreeBar) {
  EXPECT_EQ(check_ordering(triangle(), {{0, 0, true}, {1, 1, true}, {2, 0, false}}), "");
}

TEST(CheckOrdering, NamesWhatIsWrong) {
  EXPECT_EQ(check_ordering(triangle(), {{0, 0, true}, {3, 1, true}}), "bar 3 unknown");
  EXPECT_EQ(check_ordering(triangle(), {{0, 0, true}, {0, 1, true}}), "bar 0 - 1 appears twice");
  EXPECT_EQ(check_ordering(triangle(), {{0, 2, true}}),
            "bar 0 - 1 has a near joint that is not its end");
  EXPECT_EQ(check_ordering(triangle(), {{0, 0, true}, {1, 1, true}, {2, 0, true}}),
            "tree bar 2 - 0 closes a cycle");
  EXPECT_EQ(check_ordering(triangle(), {{0, 0, true}, {2, 0, true}}), "bar 1 - 2 is missing");
}

TEST(CheckOrdering, HoldsTheOrderingToItsPromisesOnly) {
  EXPECT_EQ(check_ordering(triangle(), {{0, 0, true}, {2, 0, true}}, {.all_bars = false}), "");
  EXPECT_EQ(
      check_ordering(triangle(), {{0, 0, true}, {1, 1, true}, {2, 0, true}}, {.tree_bars = false}),
      "");
}

}  // namespace check_ordering_test
}  // namespace pliant
