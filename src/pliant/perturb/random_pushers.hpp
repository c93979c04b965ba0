// SPDX-License-Identifier: MIT
// Pushers with random pushes: force, force_all, displacement.
#pragma once

#include <memory>

#include "pliant/perturb/pusher.hpp"

namespace pliant {

std::unique_ptr<Pusher> make_force(const Framework& framework, const PusherOptions& options);
std::unique_ptr<Pusher> make_force_all(const Framework& framework, const PusherOptions& options);
std::unique_ptr<Pusher> make_displacement(const Framework& framework, const PusherOptions& options);

}  // namespace pliant
