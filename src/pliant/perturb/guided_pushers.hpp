// SPDX-License-Identifier: MIT
// The pushers that follow a Guide. Their pushes depend only on the step and the positions.
#pragma once

#include <memory>

#include "pliant/perturb/pusher.hpp"

namespace pliant {

/// Moves joints back and forth along a field in a triangular wave: at step s joint i has been
/// displaced by u(s) rock_i; in a period u goes from 0 to 1, to -1 and to 0 again. Never ends.
std::unique_ptr<Pusher> make_rock(const Framework& framework, const PusherOptions& options);

/// Moves each group as a whole towards its target by at most `displacement` a step; ends once all
/// groups have arrived, within guide_slack.
std::unique_ptr<Pusher> make_pull(const Framework& framework, const PusherOptions& options);

/// Moves both groups of each pair along the line between their centres, half each, by at most
/// `displacement` a step; ends once all distances are reached, within guide_slack.
std::unique_ptr<Pusher> make_pair_distance(const Framework& framework,
                                           const PusherOptions& options);

}  // namespace pliant
