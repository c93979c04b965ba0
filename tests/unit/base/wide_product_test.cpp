// SPDX-License-Identifier: MIT
#include "pliant/base/wide_product.hpp"

#include <gtest/gtest.h>

#include "pliant/base/random.hpp"

namespace pliant {
namespace wide_product_test {

constexpr std::uint64_t all_ones = ~std::uint64_t{0};

// (2^64 - 1)^2 = 2^128 - 2^65 + 1.
static_assert(wide_product_of_halves(all_ones, all_ones) == WideProduct{all_ones - 1, 1});
static_assert(wide_product_of_halves(1u << 31, 2) == WideProduct{0, std::uint64_t{1} << 32});
static_assert(wide_product_of_halves(std::uint64_t{1} << 63, 2) == WideProduct{1, 0});

TEST(WideProduct, HalvesGiveWhatTheProcessorGives) {
  for (std::uint64_t k = 0; k < 20000; ++k) {
    const auto draws = philox4x64({k, 0, 0, 0}, {1, 2});
    for (std::uint64_t a : {draws[0], draws[0] >> 40, all_ones})
      for (std::uint64_t b : {draws[1], draws[1] >> 33, all_ones})
        ASSERT_EQ(wide_product(a, b), wide_product_of_halves(a, b)) << a << " " << b;
  }
}

}  // namespace wide_product_test
}  // namespace pliant
