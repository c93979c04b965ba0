// SPDX-License-Identifier: MIT
// Options of a run in a force file, besides those that every force file has.
#pragma once

#include <vector>

#include "pliant/perturb/force_files/force_header.hpp"
#include "pliant/run/run.hpp"

namespace pliant {

/// Options with unusual values, except timestep, tolerance and max_sweeps (see ForceFile::set), for
/// a run whose perturbation is to be repeated from its seed.
std::vector<ForceSetting> force_settings(const RunOptions& options);

/// The same for a run whose pushes are all listed, without the options that made them. A technique
/// that is a function has no name to be kept.
std::vector<ForceSetting> push_settings(const RunOptions& options);

}  // namespace pliant
