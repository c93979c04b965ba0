// SPDX-License-Identifier: MIT
// Pusher `replay`: given forces, one a step.
#pragma once

#include <memory>

#include "pliant/perturb/pusher.hpp"

namespace pliant {

/// Force k acts in step replay_from + 1 + k, whoever steps there; no other step is pushed. Throws
/// OptionError for a joint that does not exist, or a force that is not finite.
std::unique_ptr<Pusher> make_replay(const Framework& framework, const PusherOptions& options);

/// What make_replay throws.
void check_replay(const Framework& framework, std::span<const JointForce> replay);

}  // namespace pliant
