// SPDX-License-Identifier: MIT
#include "pliant/sample/network/lowest_modes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "pliant/base/math/normal.hpp"

namespace pliant {
namespace lowest_modes_test {

/// Q D Q^T with these eigenvalues, Q some reflections; row k of `axes` belongs to value k.
DenseMatrix with_spectrum(const std::vector<double>& values, DenseMatrix& axes) {
  const std::size_t n = values.size();
  axes = DenseMatrix(n, n);
  for (std::size_t k = 0; k < n; ++k) axes(k, k) = 1.0;
  for (std::uint64_t turn = 0; turn < 3; ++turn) {
    std::vector<double> v(n);
    RandomSequence draws({turn, Domain::amplitude, 0, 0, 0});
    fill_normal(draws, v);
    const double square = dot_product(v, v);
    for (std::size_t k = 0; k < n; ++k)
      add_scaled(-2.0 * dot_product(axes.row(k), v) / square, v, axes.row(k));
  }
  DenseMatrix a(n, n);
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = 0; i < n; ++i) add_scaled(values[k] * axes(k, i), axes.row(k), a.row(i));
  return a;
}

TEST(SymmetricEigen, FindsAGivenSpectrum) {
  std::vector<double> values{-3.0, -3.0, 0.0, 1e-8, 2.0, 2.0, 2.0, 5.0, 40.0};
  for (std::size_t n : {std::size_t{1}, std::size_t{2}, values.size()}) {
    const std::vector<double> some(values.begin(), values.begin() + std::ptrdiff_t(n));
    DenseMatrix axes;
    const DenseMatrix a = with_spectrum(some, axes);
    const EigenPairs found = symmetric_eigen(a);
    for (std::size_t k = 0; k < n; ++k) {
      EXPECT_NEAR(found.values[k], some[k], 1e-13);
      for (std::size_t i = 0; i < n; ++i)
        EXPECT_NEAR(dot_product(a.row(i), found.vectors.row(k)),
                    found.values[k] * found.vectors(k, i), 1e-12);
      for (std::size_t j = 0; j <= k; ++j)
        EXPECT_NEAR(dot_product(found.vectors.row(j), found.vectors.row(k)), j == k, 1e-13);
    }
  }
}

/// Below and above the size at which the inverse is taken; with a null space and equal values.
TEST(LowestModes, FindsTheLowestAboveTheNullSpace) {
  for (std::size_t n : {std::size_t{60}, std::size_t{360}}) {
    std::vector<double> values(n);
    for (std::size_t k = 0; k < n; ++k) values[k] = k < 6 ? 0.0 : 0.01 * double(k * k);
    values[10] = values[11] = values[12] = values[9];
    DenseMatrix axes;
    DenseMatrix a = with_spectrum(values, axes);
    DenseMatrix still(6, n);
    for (std::size_t k = 0; k < 6; ++k)
      std::copy(axes.row(k).begin(), axes.row(k).end(), still.row(k).begin());
    const EigenPairs found = lowest_modes(a, still, 20);
    ASSERT_EQ(found.values.size(), 20u);
    for (std::size_t k = 0; k < 20; ++k) {
      EXPECT_NEAR(found.values[k] / values[k + 6], 1.0, 1e-9) << n << " " << k;
      double within = 0.0;  // the share in the axes of this value
      for (std::size_t j = 0; j < n; ++j)
        if (std::abs(values[j] - values[k + 6]) < 1e-9)
          within += std::pow(dot_product(axes.row(j), found.vectors.row(k)), 2);
      EXPECT_NEAR(within, 1.0, 1e-9) << n << " " << k;
    }
  }
}

TEST(LowestModes, GivesFewerWhereThereAreFewer) {
  DenseMatrix axes;
  const DenseMatrix a = with_spectrum({0.0, 0.0, 1.0, 2.0}, axes);
  DenseMatrix still(1, 4);
  std::copy(axes.row(0).begin(), axes.row(0).end(), still.row(0).begin());
  EXPECT_EQ(lowest_modes(a, still, 10).values.size(), 2u);
}

TEST(LowestModes, SignsAreCanonical) {
  std::vector<double> v{0.5, -2.0, 2.0};
  make_sign_canonical(v);
  EXPECT_EQ(v, (std::vector<double>{-0.5, 2.0, -2.0}));
}

}  // namespace lowest_modes_test
}  // namespace pliant
