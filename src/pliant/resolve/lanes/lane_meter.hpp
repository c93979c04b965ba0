// SPDX-License-Identifier: MIT
// measure() of the bars of all walkers in lanes.
#pragma once

#include <vector>

#include "pliant/resolve/lanes/lane_method.hpp"
#include "pliant/resolve/method/walker_positions.hpp"

namespace pliant {

class LaneMeter {
 public:
  /// `kernels` must outlive it.
  LaneMeter(const Framework& framework, const Tolerance& tolerance, const LaneKernels& kernels);

  /// Returns the lanes among `lanes` (all of which stopped so) in which every length is finite, and
  /// within the tolerance if they should have converged. Writes their residuals to the summaries,
  /// as far as they are wanted.
  LaneMask confirm(const LaneVector* positions, LaneMask lanes, Stop stop, Measured measured,
                   ResolveSummary* summaries) const;

 private:
  LaneList<LaneBar> bars() const { return {bars_.data(), bars_.size()}; }
  double rms_of(const LaneResiduals& found, std::size_t lane) const;

  const LaneKernels& kernels_;
  std::vector<LaneBar> bars_;
};

}  // namespace pliant
