// SPDX-License-Identifier: MIT
// Forces of a replay and an ordering that was given, as H5MD files keep them for a run to go on.
#pragma once

#include <span>
#include <vector>

#include "pliant/order/ordering.hpp"
#include "pliant/perturb/push.hpp"
#include "pliant/record/h5md/h5md_recorder.hpp"

namespace pliant {

/// `ordering` is null where none was given.
RunInputs recorded_inputs(std::span<const JointForce> replay, const Ordering* ordering);

/// One force a step; empty: the run is no replay.
std::vector<JointForce> replay_of(const RunInputs& inputs);
/// Empty: none was given.
Ordering ordering_of(const RunInputs& inputs);

}  // namespace pliant
