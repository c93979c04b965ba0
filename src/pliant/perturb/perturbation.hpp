// SPDX-License-Identifier: MIT
// Perturbations: the pushers that a run takes by name alone.
#pragma once

#include <span>
#include <string_view>

#include "pliant/perturb/pushers.hpp"

namespace pliant {

using PerturbationEntry = PusherEntry;

/// The rows of pushers() that need nothing but PerturbOptions.
std::span<const PerturbationEntry> perturbations();

/// The row of that name. Throws OptionError listing the known names.
const PerturbationEntry& find_perturbation(std::string_view name);

}  // namespace pliant
