// SPDX-License-Identifier: MIT
// The pushers that follow a Guide. What they do follows from the step and the positions alone.
#pragma once

#include <memory>

#include "pliant/perturb/pusher.hpp"

namespace pliant {

/// There and back along a field, as a triangular wave: at step s joint i has been asked for u(s)
/// rock_i, u from 0 to 1, to -1 and to 0 again in a period. Never ends.
std::unique_ptr<Pusher> make_rock(const Framework& framework, const PusherOptions& options);

/// Moves each group as a whole towards where it is pulled, `displacement` a step at most; ends once
/// all have arrived, within guide_slack.
std::unique_ptr<Pusher> make_pull(const Framework& framework, const PusherOptions& options);

/// Moves both groups of each pair along the line of their centres, half each, `displacement` a step
/// at most; ends once all pairs are reached, within guide_slack.
std::unique_ptr<Pusher> make_pair_distance(const Framework& framework,
                                           const PusherOptions& options);

}  // namespace pliant
