// SPDX-License-Identifier: MIT
// Runs the walkers of pliant run, each into its own trajectory.
#pragma once

#include <vector>

#include "options/run_settings.hpp"
#include "pliant/run/run.hpp"

namespace pliant::app {

/// Runs all walkers over `settings.threads` threads, up to eight in step on each. What a walker
/// does depends on the seed and its number alone. A walker that cannot be recorded stops; the
/// others go on. `last` gets the positions of one walker that ran alone. Throws what the first
/// failing walker threw, after all have ended.
std::vector<RunSummary> run_walkers(const RunSettings& settings, const Molecule& molecule,
                                    const Log& log, std::vector<Vec3>& last,
                                    LiveRun* live = nullptr);

}  // namespace pliant::app
