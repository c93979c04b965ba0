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

/// Ends the resolve of some lanes.
class LaneEnd {
 public:
  virtual ~LaneEnd() = default;
  /// These lanes are done as they stand: their summaries' counts are final.
  virtual void finish(LaneMask lanes, Stop stop) = 0;
  /// The same of lanes in which every bar has been seen to be whole where it is.
  virtual void finish_whole(LaneMask lanes) = 0;
};

/// One resolve of up to eight walkers that share the root.
struct LaneCall {
  LaneVector* positions = nullptr;        ///< (N) to be moved
  const LaneVector* reference = nullptr;  ///< (N) positions before the push, or none
  Joint root = 0;
  LaneMask lanes = 0;                   ///< those that hold a walker
  ResolveSummary* summaries = nullptr;  ///< (8) of the lanes; counts begin at 0
  LaneEnd& end;

  /// Calls `add(summary, lane)` for each of these lanes.
  template <class Add>
  void each(LaneMask of, Add add) const {
    for (std::size_t lane = 0; lane < lane_count; ++lane)
      if (of >> lane & 1) add(summaries[lane], lane);
  }
};

class LaneMethod {
 public:
  virtual ~LaneMethod() = default;
  /// Finishes lanes exactly as Method::resolve would have ended alone, bit by bit. Lanes that it
  /// does not finish are resolved alone, from their start.
  virtual void resolve(const LaneCall& call) = 0;
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
