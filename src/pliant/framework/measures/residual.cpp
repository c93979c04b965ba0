// SPDX-License-Identifier: MIT
#include "pliant/framework/measures/residual.hpp"
#include "pliant/framework/measures/neighbour_list.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace pliant {
namespace {

ResidualSummary measure_bars(const Framework& framework, std::span<const Vec3> positions,
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

void measure_limits(const Framework& framework, std::span<const Vec3> positions,
                    const Tolerance& tolerance, LimitsOff off, ResidualSummary& summary) {
  for (LimitIndex k = 0; k < framework.limits().size(); ++k) {
    if (is_off(off, k)) continue;
    const Limit& limit = framework.limits()[k];
    const double length = distance(positions[limit.a], positions[limit.b]);
    const double outside = std::abs(excess(limit, length));
    if (!std::isfinite(length)) {
      summary.finite = summary.within = false;
      summary.max_limit = length;
      summary.worst_limit = k;
      return;
    }
    if (!(outside <= tolerance.limit)) summary.within = false;
    if (outside > summary.max_limit) {
      summary.max_limit = outside;
      summary.worst_limit = k;
    }
  }
}

void measure_overlaps(std::span<const Vec3> positions, const Tolerance& tolerance,
                      NeighbourList& neighbours, ResidualSummary& summary) {
  if (!neighbours.update(positions)) {
    summary.finite = summary.within = false;
    return;
  }
  for (const NeighbourPair& pair : neighbours.near()) {
    const double overlap = pair.least - distance(positions[pair.a], positions[pair.b]);
    if (overlap > tolerance.overlap) summary.within = false;
    if (overlap > summary.max_overlap) {
      summary.max_overlap = overlap;
      summary.worst_overlap = {pair.a, pair.b};
    }
  }
}

}  // namespace

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
                        const Tolerance& tolerance, LimitsOff off, NeighbourList* neighbours) {
  ResidualSummary summary = measure_bars(framework, positions, tolerance);
  if (framework.has_bars_only() || !summary.finite) return summary;
  measure_limits(framework, positions, tolerance, off, summary);
  if (framework.sterics() == nullptr || !summary.finite) return summary;
  std::optional<NeighbourList> own;
  if (neighbours == nullptr) neighbours = &own.emplace(framework);
  measure_overlaps(positions, tolerance, *neighbours, summary);
  return summary;
}

}  // namespace pliant
