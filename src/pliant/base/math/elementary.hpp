// SPDX-License-Identifier: MIT
// Exponential, logarithm, cosine and arctangent by sums and products in one fixed order. Those of
// C libraries differ in their last bits from one library to the next; these give the same bits
// everywhere.
#pragma once

namespace pliant {

/// e^x within 4e-16 of itself for x from -700 to 700; 0 below, infinite above, NaN of NaN.
/// x = k ln 2 + r, then Taylor's series of r.
double exact_bits_exp(double x);

/// ln x within 1e-15 of itself or of 1, for normal numbers above 0; NaN for anything else.
/// x = 2^k m, then ln m = 2 artanh((m - 1) / (m + 1)) as a series.
double exact_bits_log(double x);

/// cos x within 5e-16 for x from -100 to 100; NaN for anything else.
/// x = k pi/2 + r, then Taylor's series of cosine or sine of r.
double exact_bits_cos(double x);

/// The angle of the point (x, y), -pi to pi, within 1e-15; 0 at the origin. Both are finite.
/// arctan of the nearest eighth by a table, of what is left by its series.
double exact_bits_atan2(double y, double x);

/// The angle, 0 to pi, whose cosine is x, within 1e-15; NaN where there is none.
/// That of the point (x, sqrt(1 - x^2)).
double exact_bits_acos(double x);

}  // namespace pliant
