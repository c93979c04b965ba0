// SPDX-License-Identifier: MIT
// Up to eight walkers in lanes: they are taken in, resolved, and given back as they end.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "pliant/resolve/lanes/lane_meter.hpp"
#include "pliant/resolve/lanes/lane_method.hpp"

namespace pliant {

class LaneGroup {
 public:
  /// `kernels` and what `method` was made from must outlive it.
  LaneGroup(const Framework& framework, const Tolerance& tolerance, const LaneKernels& kernels,
            std::unique_ptr<LaneMethod> method);

  /// Moves the positions of one to eight walkers and fills their summaries, except for the seconds.
  /// Returns the lanes that ended; the others have not been moved, and are to be resolved alone.
  /// The references of the walkers have one size, or are all empty.
  LaneMask resolve(std::span<const WalkerPositions> walkers, std::span<ResolveSummary> summaries,
                   Joint root, Measured measured);

 private:
  void take_in();
  template <class RowOf>
  void gather(RowOf row_of, std::vector<LaneVector>& out) const;
  /// Gives back the walkers that ended, and returns their lanes.
  LaneMask end(const LaneEnds& ends, Measured measured);
  LaneMask end_if_confirmed(LaneMask lanes, Stop stop, Measured measured);
  LaneMask give_back(LaneMask lanes, Stop stop);

  const LaneKernels& kernels_;
  std::unique_ptr<LaneMethod> method_;
  LaneMeter meter_;
  std::vector<LaneVector> positions_, reference_;
  std::span<const WalkerPositions> walkers_;  ///< of this resolve
  std::span<ResolveSummary> summaries_;       ///< of this resolve
};

}  // namespace pliant
