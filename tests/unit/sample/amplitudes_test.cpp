// SPDX-License-Identifier: MIT
#include "pliant/sample/amplitudes.hpp"

#include <gtest/gtest.h>

namespace pliant {
namespace amplitudes_test {

/// Mean 0 and covariance 1, which independent draws would miss by a tenth.
TEST(Amplitudes, ABlockIsWhite) {
  for (std::size_t modes : {std::size_t{1}, std::size_t{60}, std::size_t{99}}) {
    const DenseMatrix a = white_amplitudes(3, 5, modes);
    ASSERT_EQ(a.rows(), 100u);
    for (std::size_t m = 0; m < modes; ++m) {
      double mean = 0.0;
      for (std::size_t f = 0; f < 100; ++f) mean += a(f, m) / 100.0;
      EXPECT_NEAR(mean, 0.0, 1e-13);
      for (std::size_t k = 0; k <= m; ++k) {
        double product = 0.0;
        for (std::size_t f = 0; f < 100; ++f) product += a(f, m) * a(f, k) / 100.0;
        EXPECT_NEAR(product, m == k, 1e-12) << m << " " << k;
      }
    }
  }
}

TEST(Amplitudes, DependOnSeedAndBlockAlone) {
  const DenseMatrix one = white_amplitudes(3, 5, 20);
  const auto differs = [&](const DenseMatrix& other) {
    return !std::equal(one.row(7).begin(), one.row(7).end(), other.row(7).begin());
  };
  EXPECT_FALSE(differs(white_amplitudes(3, 5, 20)));
  EXPECT_TRUE(differs(white_amplitudes(3, 6, 20)));
  EXPECT_TRUE(differs(white_amplitudes(4, 5, 20)));
  EXPECT_FALSE(differs(white_amplitudes(3, 5, 30))) << "more modes do not change the first";
  EXPECT_NE(redrawn_amplitudes(3, 5, 1, 20), redrawn_amplitudes(3, 5, 2, 20));
}

}  // namespace amplitudes_test
}  // namespace pliant
