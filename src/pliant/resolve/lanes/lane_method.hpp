// SPDX-License-Identifier: MIT
// The interface of techniques that resolve eight walkers at once.
#pragma once

#include <memory>
#include <vector>

#include "pliant/resolve/lanes/lane_kernels.hpp"
#include "pliant/resolve/method/resolve_options.hpp"
#include "pliant/resolve/method/resolve_summary.hpp"
#include "pliant/resolve/method/technique.hpp"

namespace pliant {

/// How lanes ended. Lanes in no set are resolved alone, from their start.
struct LaneEnds {
  LaneMask whole = 0;       ///< every bar was found to be whole at its final positions
  LaneMask converged = 0;   ///< presumably whole
  LaneMask max_sweeps = 0;  ///< the limit was reached
  LaneMask stopped = 0;     ///< by the caller
  LaneMask left = 0;        ///< not ended yet
};

/// One resolve of up to eight walkers with the same root.
struct LaneCall {
  LaneVector* positions = nullptr;        ///< (N) are moved
  const LaneVector* reference = nullptr;  ///< (N) positions before the push, or none
  Joint root = 0;
  LaneMask lanes = 0;                   ///< those that hold a walker
  ResolveSummary* summaries = nullptr;  ///< of each lane with a walker; counts begin at 0

  /// Calls `add(summary, lane)` for each of these lanes.
  template <class Add>
  void each(LaneMask of, Add add) const {
    for (std::size_t lane = 0; lane < lane_count; ++lane)
      if (of >> lane & 1) add(summaries[lane], lane);
  }
};

/// Ends each lane exactly as Method::resolve alone would, bit by bit. A resolve is begin() and,
/// while lanes are left, go_on(). Lanes that ended must be taken out before the next call, which
/// moves the joints of all.
class LaneMethod {
 public:
  virtual ~LaneMethod() = default;
  /// Ends lanes that need not be moved.
  virtual LaneEnds begin(const LaneCall& call) { return {.left = call.lanes}; }
  /// Continues with the lanes that are left until some may have ended. Counts in the summaries.
  virtual LaneEnds go_on(const LaneCall& call, LaneMask left) = 0;
  /// Whether it needs LaneCall::reference.
  virtual bool needs_reference() const { return false; }
};

/// What a lane method is made from; all must outlive it.
struct LaneSetting {
  const Framework& framework;
  const Technique& technique;
  const ResolveOptions& options;
  const LaneKernels& kernels;
};

/// The framework's bars with the error that each is allowed, in the framework's sequence.
std::vector<LaneBar> lane_bars(const Framework& framework, const Tolerance& tolerance);

/// Memory for the largest of several parts.
class LaneScratch {
 public:
  void fit(const BarPattern& part);
  LaneRoom room();

 private:
  std::vector<LaneVector> x_, best_, directions_, along_;
  std::vector<LaneValue> excess_, diagonal_, inverse_, lower_;
};

}  // namespace pliant
