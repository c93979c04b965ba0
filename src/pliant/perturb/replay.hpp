// SPDX-License-Identifier: MIT
// Pusher `replay`: given forces, one a step or as many as counted.
#pragma once

#include <memory>

#include "pliant/perturb/pusher.hpp"

namespace pliant {

/// The k-th force, or the forces of the k-th count, act in step replay_from + 1 + k, whoever steps
/// there; no other step is pushed. Throws OptionError for a joint that does not exist, a force that
/// is not finite, or counts that do not add up to the forces.
std::unique_ptr<Pusher> make_replay(const Framework& framework, const PusherOptions& options);

/// What make_replay throws.
void check_replay(const Framework& framework, std::span<const JointForce> replay);

/// Throws OptionError unless the counts, if there are any, are of these forces.
void check_counts(std::span<const JointForce> replay, std::span<const std::int64_t> counts);

}  // namespace pliant
