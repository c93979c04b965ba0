// SPDX-License-Identifier: MIT
// What techniques that resolve eight walkers at once are made of on the inside.
#pragma once

#include <memory>
#include <vector>

#include "pliant/resolve/lanes/lane_kernels.hpp"
#include "pliant/resolve/method/resolve_options.hpp"
#include "pliant/resolve/method/resolve_summary.hpp"
#include "pliant/resolve/method/technique.hpp"

namespace pliant {

/// How lanes ended. Those named nowhere are resolved alone, from their start.
struct LaneEnds {
  LaneMask whole = 0;       ///< every bar has been seen to be whole where it is
  LaneMask converged = 0;   ///< believed whole
  LaneMask max_sweeps = 0;  ///< the limit is met
  LaneMask stopped = 0;     ///< by the caller's wish
  LaneMask left = 0;        ///< not ended yet
};

/// One resolve of up to eight walkers that share the root.
struct LaneCall {
  LaneVector* positions = nullptr;        ///< (N) to be moved
  const LaneVector* reference = nullptr;  ///< (N) positions before the push, or none
  Joint root = 0;
  LaneMask lanes = 0;                   ///< those that hold a walker
  ResolveSummary* summaries = nullptr;  ///< of each lane that holds one; counts begin at 0

  /// Calls `add(summary, lane)` for each of these lanes.
  template <class Add>
  void each(LaneMask of, Add add) const {
    for (std::size_t lane = 0; lane < lane_count; ++lane)
      if (of >> lane & 1) add(summaries[lane], lane);
  }
};

/// Ends lanes exactly as Method::resolve would have ended alone, bit by bit. One resolve is begin()
/// and, while lanes are left, go_on(): what lanes end with is to be taken out before the next,
/// which moves the joints of all.
class LaneMethod {
 public:
  virtual ~LaneMethod() = default;
  /// Ends what need not be moved.
  virtual LaneEnds begin(const LaneCall& call) { return {.left = call.lanes}; }
  /// Goes on with the lanes that are left to where some may have ended. Counts in the summaries.
  virtual LaneEnds go_on(const LaneCall& call, LaneMask left) = 0;
  /// Whether it looks at LaneCall::reference.
  virtual bool needs_reference() const { return false; }
};

/// What a lane method is made from; all outlive it.
struct LaneSetting {
  const Framework& framework;
  const Technique& technique;
  const ResolveOptions& options;
  const LaneKernels& kernels;
};

/// The framework's bars with what each is allowed, in the framework's sequence.
std::vector<LaneBar> lane_bars(const Framework& framework, const Tolerance& tolerance);

/// Memory for the largest of some parts.
class LaneScratch {
 public:
  void fit(const BarPattern& part);
  LaneRoom room();

 private:
  std::vector<LaneVector> x_, best_, directions_, along_;
  std::vector<LaneValue> excess_, diagonal_, inverse_, lower_;
};

}  // namespace pliant
