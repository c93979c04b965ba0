// SPDX-License-Identifier: MIT
// One line of a force file with a joint and a force on it.
#pragma once

#include <string>
#include <string_view>

#include "pliant/base/words.hpp"
#include "pliant/framework/joint_names.hpp"
#include "pliant/perturb/push.hpp"

namespace pliant {

/// Parses the words of "push C1 12.5 -3 0.25". Throws InputError at `place`.
JointForce force_of(const Words& words, const JointNames& names, const Place& place);

/// Returns the line, which force_of() reads back to the same bits. Throws as JointNames::word_for.
std::string force_line(std::string_view word, const JointForce& force, const JointNames& names);

}  // namespace pliant
