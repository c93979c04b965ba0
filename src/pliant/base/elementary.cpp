// SPDX-License-Identifier: MIT
#include "pliant/base/elementary.hpp"

#include <cmath>
#include <limits>
#include <numbers>

namespace pliant {
namespace {

// ln 2 in two parts: the first has 32 bits, so that a whole number times it is exact.
constexpr double ln2_high = 6.93147180369123816490e-01;
constexpr double ln2_low = 1.90821492927058770002e-10;
constexpr double largest_exponent = 700.0;
constexpr int exp_terms = 14;
constexpr int log_terms = 12;
// pi/2 in two parts: the first has 33 bits.
constexpr double half_pi_high = 1.57079632673412561417e+00;
constexpr double half_pi_low = 6.07710050650619224932e-11;
constexpr double largest_angle = 100.0;
constexpr int cos_terms = 18;     // powers of the series
constexpr int arctan_terms = 14;  // of t up to 0.2

double cos_series(double r) {
  double sum = 1.0;
  for (int n = cos_terms; n > 0; n -= 2) sum = 1.0 - sum * r * r / (n * (n - 1));
  return sum;
}

double sin_series(double r) {
  double sum = 1.0;
  for (int n = cos_terms; n > 0; n -= 2) sum = 1.0 - sum * r * r / (n * (n + 1));
  return r * sum;
}

/// Of t from 0 to 1.
double arctan(double t) {
  for (int half = 0; half < 2; ++half) t = t / (1.0 + std::sqrt(1.0 + t * t));
  const double square = t * t;
  double sum = 0.0;
  for (int n = arctan_terms; n >= 0; --n) sum = 1.0 / (2 * n + 1) - sum * square;
  return 4.0 * t * sum;
}

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

double exact_bits_cos(double x) {
  if (!(std::abs(x) <= largest_angle)) return std::numeric_limits<double>::quiet_NaN();
  const double k = std::floor(x / half_pi_high + 0.5);
  const double r = (x - k * half_pi_high) - k * half_pi_low;
  switch (static_cast<int>(k) & 3) {
    case 0:
      return cos_series(r);
    case 1:
      return -sin_series(r);
    case 2:
      return -cos_series(r);
    default:
      return sin_series(r);
  }
}

double exact_bits_acos(double x) {
  if (!(std::abs(x) <= 1.0)) return std::numeric_limits<double>::quiet_NaN();
  if (x < 0.0) return std::numbers::pi - exact_bits_acos(-x);
  return 2.0 * arctan(std::sqrt((1.0 - x) / (1.0 + x)));
}

}  // namespace pliant
