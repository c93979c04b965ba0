// SPDX-License-Identifier: MIT
// Residuals (length errors) of bars, violations of limits and sterics, and the one definition of
// tolerances, used by the resolver, the tests and the recorder.
#pragma once

#include <span>

#include "pliant/framework/framework.hpp"

namespace pliant {

class NeighbourList;

/// Signed length error |b - a| - rest of a bar (Angstrom): positive when it is too long.
inline double residual(Vec3 a, Vec3 b, double rest) { return distance(a, b) - rest; }

/// When a bar counts as whole, a limit as held, and two joints as not overlapping.
struct Tolerance {
  double relative = 1e-6;  ///< largest |length - rest| / rest (as OpenMM); used if length is 0
  double length = 0.0;     ///< largest |length - rest| in Angstrom (as the thesis); 0: not used
  double limit = 1e-2;     ///< how far a limit's distance may be outside its interval (Angstrom)
  double overlap = 0.1;    ///< how much nearer than allowed two joints may be (Angstrom)

  /// The largest |length - rest| accepted of a bar with this rest length (Angstrom).
  double of(double rest) const { return length > 0.0 ? length : relative * rest; }
};

/// How far a framework is from its rest lengths, its limits and its sterics.
struct ResidualSummary {
  double max_relative = 0.0;   ///< largest |length - rest| / rest
  double rms_relative = 0.0;   ///< root of the mean of its square
  double max_length = 0.0;     ///< largest |length - rest| (Angstrom)
  BarIndex worst_bar = 0;      ///< the bar of max_relative; 0 when there is no bar
  bool within = true;          ///< everything is within the tolerance
  bool finite = true;          ///< every length is a finite number
  double max_limit = 0.0;      ///< largest distance of a limit outside its interval (Angstrom)
  LimitIndex worst_limit = 0;  ///< the limit of max_limit; 0 when all are within
  double max_overlap = 0.0;    ///< largest least distance less distance of two joints (Angstrom)
  Bar worst_overlap = {};      ///< the joints of max_overlap; both 0 when none overlap
};

/// Whether every bar is within the tolerance. Stops at the first that is not; ignores limits and
/// sterics.
bool is_whole(const Framework& framework, std::span<const Vec3> positions,
              const Tolerance& tolerance);

/// Measures all bars at `positions` (N), the limits that are not `off`, and overlaps, in linear
/// time. `neighbours` are this framework's, kept from call to call; without them they are found
/// anew. If a length is not finite, `finite` and `within` are false and worst_bar or worst_limit
/// says where.
ResidualSummary measure(const Framework& framework, std::span<const Vec3> positions,
                        const Tolerance& tolerance = {}, LimitsOff off = {},
                        NeighbourList* neighbours = nullptr);

}  // namespace pliant
