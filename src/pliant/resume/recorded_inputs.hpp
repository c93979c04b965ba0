// SPDX-License-Identifier: MIT
// Forces of a replay, a guide and an ordering that was given, as H5MD files keep them for a run to
// go on.
#pragma once

#include <span>
#include <vector>

#include "pliant/order/ordering.hpp"
#include "pliant/perturb/guide.hpp"
#include "pliant/perturb/push.hpp"
#include "pliant/record/h5md/h5md_recorder.hpp"

namespace pliant {

/// `ordering` is null where none was given; `replay_counts` as in RunOptions.
RunInputs recorded_inputs(std::span<const JointForce> replay, const Guide& guide,
                          const Ordering* ordering,
                          std::span<const std::int64_t> replay_counts = {});

/// One force a step, or as many as inputs.replay_counts say; empty: the run is no replay.
std::vector<JointForce> replay_of(const RunInputs& inputs);
/// Empty: the run followed none. Throws InputError where its parts do not fit together.
Guide guide_of(const RunInputs& inputs);
/// Empty: none was given.
Ordering ordering_of(const RunInputs& inputs);

}  // namespace pliant
