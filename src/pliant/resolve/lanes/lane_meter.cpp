// SPDX-License-Identifier: MIT
#include "pliant/resolve/lanes/lane_meter.hpp"

#include <algorithm>
#include <cmath>

namespace pliant {

LaneMeter::LaneMeter(const Framework& framework, const Tolerance& tolerance,
                     const LaneKernels& kernels)
    : kernels_(kernels), bars_(lane_bars(framework, tolerance)) {}

LaneMask LaneMeter::confirm(const LaneVector* positions, LaneMask lanes, Stop stop,
                            Measured measured, ResolveSummary* summaries) const {
  if (measured == Measured::nothing && stop == Stop::converged)
    return LaneMask(lanes & kernels_.confirm_whole(bars(), positions));
  const bool wants_rms = measured == Measured::rms_residual;
  const LaneResiduals found = kernels_.measure(bars(), positions, wants_rms);
  lanes = LaneMask(lanes & found.finite);
  if (stop == Stop::converged) lanes = LaneMask(lanes & found.within);
  if (measured == Measured::nothing) return lanes;
  for (std::size_t lane = 0; lane < lane_count; ++lane) {
    if (!(lanes >> lane & 1)) continue;
    summaries[lane].max_residual = found.max_relative[lane];
    summaries[lane].worst_bar = found.worst_bar[lane];
    if (wants_rms) summaries[lane].rms_residual = rms_of(found, lane);
  }
  return lanes;
}

/// Adds up as measure() does.
double LaneMeter::rms_of(const LaneResiduals& found, std::size_t lane) const {
  if (bars_.empty()) return 0.0;
  return std::min(std::sqrt(found.sum_of_squares[lane] / double(bars_.size())),
                  found.max_relative[lane]);
}

}  // namespace pliant
