// SPDX-License-Identifier: MIT
#include "pliant/base/math/elementary.hpp"

#include <algorithm>
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
constexpr int cos_terms = 18;  // powers of the series
// Series for t up to 1/16, the highest power first: the term of t^15 is below 6e-20.
constexpr double arctan_series[] = {1.0 / 13, 1.0 / 11, 1.0 / 9, 1.0 / 7, 1.0 / 5, 1.0 / 3, 1.0};
constexpr double arctan_of_eighths[] = {0.0,
                                        0.12435499454676143503,
                                        0.24497866312686415417,
                                        0.3587706702705722204,
                                        0.46364760900080611621,
                                        0.55859931534356243597,
                                        0.6435011087932843868,
                                        0.71882999962162450542,
                                        0.78539816339744830962};

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

/// For t from 0 to 1: arctan t = arctan c + arctan((t - c) / (1 + t c)), c the nearest eighth.
double arctan(double t) {
  // NOLINTNEXTLINE(bugprone-incorrect-roundings): t is not negative
  const int eighth = static_cast<int>(8.0 * t + 0.5);
  const double c = 0.125 * eighth;
  const double r = (t - c) / (1.0 + t * c), square = r * r;
  double sum = 0.0;
  for (const double term : arctan_series) sum = term - sum * square;
  return arctan_of_eighths[eighth] + r * sum;
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

double exact_bits_atan2(double y, double x) {
  constexpr double right = 0.5 * std::numbers::pi;
  constexpr double from[] = {0.0, right, std::numbers::pi, right}, sign[] = {1.0, -1.0, -1.0, 1.0};
  const double up = std::abs(y), along = std::abs(x);
  const double low = std::min(up, along), high = std::max(up, along);
  const int octant = static_cast<int>(up > along) + 2 * static_cast<int>(x < 0.0);
  const bool has_angle = high > 0.0 && high <= std::numeric_limits<double>::max();
  const double angle = has_angle ? arctan(low / high) : 0.0;
  return std::copysign(from[octant] + sign[octant] * angle, y);
}

double exact_bits_acos(double x) {
  if (!(std::abs(x) <= 1.0)) return std::numeric_limits<double>::quiet_NaN();
  return exact_bits_atan2(std::sqrt((1.0 - x) * (1.0 + x)), x);
}

}  // namespace pliant
