// SPDX-License-Identifier: MIT
// Joints in requests.
#pragma once

#include "pliant/framework/framework.hpp"
#include "reply.hpp"

namespace pliant::play {

/// Throws OptionError for what is no whole number from 0.
Joint joint_of(const Json& number);

}  // namespace pliant::play
