// SPDX-License-Identifier: MIT
#include "pliant/base/math/elementary.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "pliant/base/math/normal.hpp"

namespace pliant {
namespace elementary_test {

TEST(Elementary, ExpIsThatOfTheLibraryToRounding) {
  for (double x = -690.0; x <= 690.0; x += 0.37)
    EXPECT_NEAR(exact_bits_exp(x) / std::exp(x), 1.0, 5e-16) << x;
  EXPECT_EQ(exact_bits_exp(0.0), 1.0);
  EXPECT_EQ(exact_bits_exp(-1e4), 0.0);
  EXPECT_TRUE(std::isinf(exact_bits_exp(1e4)));
}

TEST(Elementary, LogIsThatOfTheLibraryToRounding) {
  for (double x = 1e-300; x < 1e300; x *= 1.7)
    EXPECT_NEAR(exact_bits_log(x), std::log(x), 1e-15 * std::max(1.0, std::abs(std::log(x)))) << x;
  EXPECT_EQ(exact_bits_log(1.0), 0.0);
  for (double x : {0.0, -1.0, std::numeric_limits<double>::infinity()})
    EXPECT_TRUE(std::isnan(exact_bits_log(x))) << x;
}

TEST(Elementary, CosIsThatOfTheLibraryToRounding) {
  for (double x = -100.0; x <= 100.0; x += 0.0137)
    EXPECT_NEAR(exact_bits_cos(x), std::cos(x), 5e-16) << x;
  EXPECT_EQ(exact_bits_cos(0.0), 1.0);
  for (double x : {101.0, -1e300, std::numeric_limits<double>::infinity()})
    EXPECT_TRUE(std::isnan(exact_bits_cos(x))) << x;
}

TEST(Elementary, Atan2IsThatOfTheLibraryToRounding) {
  for (double angle = -3.14159; angle < 3.1416; angle += 1.7e-5) {
    const double y = 3.7 * std::sin(angle), x = 3.7 * std::cos(angle);
    EXPECT_NEAR(exact_bits_atan2(y, x), std::atan2(y, x), 1e-15) << angle;
  }
  for (double small : {1e-300, 1e-20, 1e-9, 1e-3})
    EXPECT_NEAR(exact_bits_atan2(small, 2.0) / std::atan2(small, 2.0), 1.0, 1e-15) << small;
  for (double y : {-2.0, 0.0, 2.0})
    for (double x : {-2.0, 0.0, 2.0}) EXPECT_EQ(exact_bits_atan2(y, x), std::atan2(y, x));
}

TEST(Elementary, AcosIsThatOfTheLibraryToRounding) {
  for (int k = -100000; k <= 100000; k += 7)
    EXPECT_NEAR(exact_bits_acos(k * 1e-5), std::acos(k * 1e-5), 1e-15) << k;
  EXPECT_EQ(exact_bits_acos(1.0), 0.0);
  EXPECT_EQ(exact_bits_acos(-1.0), std::acos(-1.0));
  EXPECT_NEAR(exact_bits_acos(1.0 - 1e-15) / std::acos(1.0 - 1e-15), 1.0, 1e-14);
  EXPECT_TRUE(std::isnan(exact_bits_acos(1.0000001)));
}

/// Moments of the normal distribution: 0, 1, 0, 3; the bounds are five standard errors.
TEST(Normal, HasTheMomentsOfTheNormalDistribution) {
  std::vector<double> numbers(200001);
  RandomSequence draws({7, Domain::amplitude, 0, 0, 0});
  fill_normal(draws, numbers);
  const auto count = double(numbers.size());
  const double expected[] = {0.0, 1.0, 0.0, 3.0}, variance[] = {1.0, 2.0, 15.0, 96.0};
  for (int power = 1; power <= 4; ++power) {
    double sum = 0.0;
    for (double x : numbers) sum += std::pow(x, power);
    EXPECT_NEAR(sum / count, expected[power - 1], 5.0 * std::sqrt(variance[power - 1] / count));
  }
}

}  // namespace elementary_test
}  // namespace pliant
