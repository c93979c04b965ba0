// SPDX-License-Identifier: MIT
#include "pliant/resolve/lanes/lane_group.hpp"

#include <algorithm>
#include <utility>

namespace pliant {
namespace {

ResolveSummary begun() {
  ResolveSummary summary;
  summary.sweeps = summary.projections = 0;
  summary.dropped_bars = summary.finishing_sweeps = 0;
  return summary;
}

}  // namespace

LaneGroup::LaneGroup(const Framework& framework, const Tolerance& tolerance,
                     const LaneKernels& kernels, std::unique_ptr<LaneMethod> method)
    : kernels_(kernels),
      method_(std::move(method)),
      meter_(framework, tolerance, kernels),
      positions_(framework.joint_count()) {}

LaneMask LaneGroup::resolve(std::span<const WalkerPositions> walkers,
                            std::span<ResolveSummary> summaries, Joint root, Measured measured) {
  walkers_ = walkers;
  summaries_ = summaries;
  std::fill(summaries_.begin(), summaries_.end(), begun());
  take_in();
  const LaneCall call{positions_.data(), reference_.empty() ? nullptr : reference_.data(), root,
                      LaneMask((1u << walkers.size()) - 1), summaries_.data()};
  LaneEnds ends = method_->begin(call);
  LaneMask ended = end(ends, measured);
  while (ends.left != 0) {
    ends = method_->go_on(call, ends.left);
    ended = LaneMask(ended | end(ends, measured));
  }
  return ended;
}

void LaneGroup::take_in() {
  gather([](const WalkerPositions& walker) { return walker.positions.data(); }, positions_);
  reference_.resize(method_->needs_reference() ? walkers_[0].reference.size() : 0);
  if (!reference_.empty())
    gather([](const WalkerPositions& walker) { return walker.reference.data(); }, reference_);
}

/// Lanes without a walker repeat the first one's.
template <class RowOf>
void LaneGroup::gather(RowOf row_of, std::vector<LaneVector>& out) const {
  const double* rows[lane_count];
  for (std::size_t lane = 0; lane < lane_count; ++lane)
    rows[lane] =
        reinterpret_cast<const double*>(row_of(walkers_[lane < walkers_.size() ? lane : 0]));
  kernels_.gather(rows, 3 * out.size(), reinterpret_cast<LaneValue*>(out.data()));
}

LaneMask LaneGroup::end(const LaneEnds& ends, Measured measured) {
  LaneMask ended = measured == Measured::nothing
                       ? give_back(ends.whole, Stop::converged)
                       : end_if_confirmed(ends.whole, Stop::converged, measured);
  ended = LaneMask(ended | end_if_confirmed(ends.converged, Stop::converged, measured));
  ended = LaneMask(ended | end_if_confirmed(ends.max_sweeps, Stop::max_sweeps, measured));
  return LaneMask(ended | end_if_confirmed(ends.stopped, Stop::stopped_by_caller, measured));
}

/// Lengths that are not finite, and walkers that were believed whole, are looked at alone.
LaneMask LaneGroup::end_if_confirmed(LaneMask lanes, Stop stop, Measured measured) {
  if (lanes == 0) return 0;
  return give_back(meter_.confirm(positions_.data(), lanes, stop, measured, summaries_.data()),
                   stop);
}

LaneMask LaneGroup::give_back(LaneMask lanes, Stop stop) {
  if (lanes == 0) return 0;
  double* rows[lane_count] = {};
  for (std::size_t lane = 0; lane < walkers_.size(); ++lane) {
    if (!(lanes >> lane & 1)) continue;
    rows[lane] = reinterpret_cast<double*>(walkers_[lane].positions.data());
    summaries_[lane].stop = stop;
  }
  kernels_.scatter(reinterpret_cast<const LaneValue*>(positions_.data()), 3 * positions_.size(),
                   rows);
  return lanes;
}

}  // namespace pliant
