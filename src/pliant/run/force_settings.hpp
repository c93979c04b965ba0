// SPDX-License-Identifier: MIT
// Options of a run that a force file keeps besides those that each of them has.
#pragma once

#include <vector>

#include "pliant/perturb/force_files/force_header.hpp"
#include "pliant/run/run.hpp"

namespace pliant {

/// Options that are not as usual, without timestep, tolerance and max_sweeps, of which
/// ForceFile::set takes care: of a run whose perturbation is to be made again from its seed.
std::vector<ForceSetting> force_settings(const RunOptions& options);

/// The same of a run whose pushes are all listed: what made them is of no matter then. A technique
/// that is a function has no name to be kept.
std::vector<ForceSetting> push_settings(const RunOptions& options);

}  // namespace pliant
