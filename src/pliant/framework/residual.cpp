// SPDX-License-Identifier: MIT
#include "pliant/framework/residual.hpp"

#include <algorithm>
#include <cmath>

namespace pliant {

bool is_whole(const Framework& framework, std::span<const Vec3> positions,
              const Tolerance& tolerance) {
  const auto bars = framework.bars();
  const auto rests = framework.rest_lengths();
  for (std::size_t k = 0; k < bars.size(); ++k) {
    const double error = residual(positions[bars[k].a], positions[bars[k].b], rests[k]);
    if (!(std::abs(error) <= tolerance.of(rests[k]))) return false;
  }
  return true;
}

ResidualSummary measure(const Framework& framework, std::span<const Vec3> positions,
                        const Tolerance& tolerance) {
  ResidualSummary summary;
  double sum_of_squares = 0.0;
  const auto bars = framework.bars();
  const auto rests = framework.rest_lengths();
  for (std::size_t k = 0; k < bars.size(); ++k) {
    const double error = std::abs(residual(positions[bars[k].a], positions[bars[k].b], rests[k]));
    const double relative = error / rests[k];
    if (!std::isfinite(error)) {
      summary.worst_bar = static_cast<BarIndex>(k);
      summary.finite = summary.within = false;
      summary.max_relative = summary.rms_relative = summary.max_length = error;
      return summary;
    }
    sum_of_squares += relative * relative;
    if (error > tolerance.of(rests[k])) summary.within = false;
    if (error > summary.max_length) summary.max_length = error;
    if (relative > summary.max_relative) {
      summary.max_relative = relative;
      summary.worst_bar = static_cast<BarIndex>(k);
    }
  }
  // The squares of absurdly long bars overflow; their mean never exceeds the largest one.
  if (!bars.empty())
    summary.rms_relative =
        std::min(std::sqrt(sum_of_squares / double(bars.size())), summary.max_relative);
  return summary;
}

}  // namespace pliant
