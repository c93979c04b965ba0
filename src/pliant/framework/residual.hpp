// SPDX-License-Identifier: MIT
// Residual (length error) of bars, and the one place where tolerances are defined. The resolver,
// the tests and the recorder all ask here.
#pragma once

#include <span>

#include "pliant/framework/framework.hpp"

namespace pliant {

/// Signed length error |b - a| - rest of a bar (Angstrom): positive when it is too long.
inline double residual(Vec3 a, Vec3 b, double rest) { return distance(a, b) - rest; }

/// When a bar counts as whole.
struct Tolerance {
  double relative = 1e-6;  ///< largest |length - rest| / rest (as OpenMM); used if length is 0
  double length = 0.0;     ///< largest |length - rest| in Angstrom (as the thesis); 0: not used

  /// The largest |length - rest| accepted of a bar with this rest length (Angstrom).
  double of(double rest) const { return length > 0.0 ? length : relative * rest; }
};

/// How far a framework is from its rest lengths.
struct ResidualSummary {
  double max_relative = 0.0;  ///< largest |length - rest| / rest
  double rms_relative = 0.0;  ///< root of the mean of its square
  double max_length = 0.0;    ///< largest |length - rest| (Angstrom)
  BarIndex worst_bar = 0;     ///< the bar of max_relative; 0 when there is no bar
  bool within = true;         ///< every bar is within the tolerance
  bool finite = true;         ///< every length is a finite number
};

/// Whether every bar is within the tolerance; looks no further than the first that is not.
bool is_whole(const Framework& framework, std::span<const Vec3> positions,
              const Tolerance& tolerance);

/// Measures all bars at `positions` (N): linear in the number of bars.
/// A length that is not finite gives finite = within = false, with worst_bar naming its bar.
ResidualSummary measure(const Framework& framework, std::span<const Vec3> positions,
                        const Tolerance& tolerance = {});

}  // namespace pliant
