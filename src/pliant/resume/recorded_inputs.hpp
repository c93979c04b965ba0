// SPDX-License-Identifier: MIT
// Forces of a replay, a guide and a given ordering, as H5MD files keep them so that a run can
// continue.
#pragma once

#include <span>
#include <vector>

#include "pliant/order/ordering.hpp"
#include "pliant/perturb/guide.hpp"
#include "pliant/perturb/push.hpp"
#include "pliant/record/h5md/h5md_recorder.hpp"

namespace pliant {

/// `ordering` is null if none was given; `replay_counts` as in RunOptions.
RunInputs recorded_inputs(std::span<const JointForce> replay, const Guide& guide,
                          const Ordering* ordering,
                          std::span<const std::int64_t> replay_counts = {});

/// The forces of a replay, one a step or by inputs.replay_counts; empty if the run is no replay.
std::vector<JointForce> replay_of(const RunInputs& inputs);
/// The guide; empty if there was none. Throws InputError if its parts are inconsistent.
Guide guide_of(const RunInputs& inputs);
/// The given ordering; empty if there was none.
Ordering ordering_of(const RunInputs& inputs);

}  // namespace pliant
