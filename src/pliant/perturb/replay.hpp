// SPDX-License-Identifier: MIT
// Pusher `replay`: given forces, one a step or by counts.
#pragma once

#include <memory>

#include "pliant/perturb/pusher.hpp"

namespace pliant {

/// In step replay_from + 1 + k the k-th force acts, or the forces of the k-th count; no other step
/// is pushed. Throws OptionError for a joint that does not exist, a force that is not finite, or
/// counts that do not add up to the number of forces.
std::unique_ptr<Pusher> make_replay(const Framework& framework, const PusherOptions& options);

/// Throws OptionError for a joint that does not exist or a force that is not finite.
void check_replay(const Framework& framework, std::span<const JointForce> replay);

/// Throws OptionError unless there are no counts or they add up to the number of forces.
void check_counts(std::span<const JointForce> replay, std::span<const std::int64_t> counts);

}  // namespace pliant
