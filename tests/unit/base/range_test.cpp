// SPDX-License-Identifier: MIT
#include "pliant/base/range.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "support/error_text.hpp"

namespace pliant {
namespace range_test {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

TEST(Range, HoldsItsEndsAndNothingBeyond) {
  EXPECT_TRUE(holds(Range::zero_to_one, 0.0));
  EXPECT_TRUE(holds(Range::zero_to_one, 1.0));
  EXPECT_FALSE(holds(Range::zero_to_one, 1.0 + 1e-15));
  EXPECT_FALSE(holds(Range::positive, 0.0));
  EXPECT_TRUE(holds(Range::positive, std::numeric_limits<double>::denorm_min()));
  EXPECT_TRUE(holds(Range::zero_or_more, 0.0));
  EXPECT_FALSE(holds(Range::zero_or_more, -1e-300));
  EXPECT_TRUE(holds(Range::positive, std::int64_t{1}));
  EXPECT_FALSE(holds(Range::positive, std::int64_t{0}));
  EXPECT_FALSE(holds(Range::zero_or_more, std::int64_t{-1}));
}

TEST(Range, HoldsFiniteNumbersOnly) {
  for (Range range : {Range::any, Range::positive, Range::zero_or_more, Range::zero_to_one}) {
    EXPECT_FALSE(holds(range, infinite));
    EXPECT_FALSE(holds(range, not_a_number));
  }
}

TEST(Range, SaysWhatMustBe) {
  const auto refusal = [](auto value, Range range) {
    return test::error_text<OptionError>([&] { check_range("size", value, range); });
  };
  EXPECT_EQ(refusal(0.0, Range::positive), "size = 0: must be positive and finite");
  EXPECT_EQ(refusal(-1.0, Range::zero_or_more), "size = -1: must be 0 or more and finite");
  EXPECT_EQ(refusal(2.0, Range::zero_to_one), "size = 2: must be from 0 to 1");
  EXPECT_EQ(refusal(infinite, Range::any), "size = inf: must be finite");
  EXPECT_EQ(refusal(std::int64_t{0}, Range::positive), "size = 0: must be from 1");
  EXPECT_EQ(refusal(std::int64_t{-3}, Range::zero_or_more), "size = -3: must be from 0");
}

}  // namespace range_test
}  // namespace pliant
