// SPDX-License-Identifier: MIT
#include "pliant/base/elementary.hpp"

#include <cmath>
#include <limits>

namespace pliant {
namespace {

// ln 2 in two parts: the first has 32 bits, so that a whole number times it is exact.
constexpr double ln2_high = 6.93147180369123816490e-01;
constexpr double ln2_low = 1.90821492927058770002e-10;
constexpr double largest_exponent = 700.0;
constexpr int exp_terms = 14;
constexpr int log_terms = 12;

}  // namespace

double exact_bits_exp(double x) {
  if (std::isnan(x)) return x;
  if (x > largest_exponent) return std::numeric_limits<double>::infinity();
  if (x < -largest_exponent) return 0.0;
  const double k = std::floor(x / ln2_high + 0.5);
  const double r = (x - k * ln2_high) - k * ln2_low;
  double sum = 1.0;
  for (int n = exp_terms; n > 0; --n) sum = 1.0 + sum * r / n;
  return std::ldexp(sum, static_cast<int>(k));
}

double exact_bits_log(double x) {
  if (!(x >= std::numeric_limits<double>::min()) || std::isinf(x))
    return std::numeric_limits<double>::quiet_NaN();
  int k = 0;
  double m = std::frexp(x, &k);
  if (m < 0.70710678118654752) {
    m *= 2.0;
    --k;
  }
  const double f = (m - 1.0) / (m + 1.0), square = f * f;
  double sum = 0.0;
  for (int n = log_terms; n >= 0; --n) sum = sum * square + 1.0 / (2 * n + 1);
  return k * ln2_high + (2.0 * f * sum + k * ln2_low);
}

}  // namespace pliant
