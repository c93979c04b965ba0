// SPDX-License-Identifier: MIT
// Exponential, logarithm, cosine and arctangent by sums and products in one fixed order: the same
// bits everywhere, whereas C libraries differ in the last bits.
#pragma once

namespace pliant {

/// e^x with a relative error of at most 4e-16 for x from -700 to 700; 0 below, infinite above, NaN
/// for NaN.
/// x = k ln 2 + r, then Taylor's series of r.
double exact_bits_exp(double x);

/// ln x for normal numbers above 0, with an error of at most 1e-15, relative or absolute; NaN for
/// anything else.
/// x = 2^k m, then ln m = 2 artanh((m - 1) / (m + 1)) as a series.
double exact_bits_log(double x);

/// cos x within 5e-16 for x from -100 to 100; NaN for anything else.
/// x = k pi/2 + r, then Taylor's series of cosine or sine of r.
double exact_bits_cos(double x);

/// The angle of the point (x, y) from -pi to pi, within 1e-15; 0 at the origin. x and y must be
/// finite. A table gives the arctangent of the nearest eighth, a series that of the remainder.
double exact_bits_atan2(double y, double x);

/// The angle from 0 to pi whose cosine is x, within 1e-15; NaN where there is none. Computed as the
/// angle of the point (x, sqrt(1 - x^2)).
double exact_bits_acos(double x);

}  // namespace pliant
