// SPDX-License-Identifier: MIT
// Runs the walkers of pliant run, each into its own trajectory.
#pragma once

#include <vector>

#include "options/run_settings.hpp"
#include "pliant/run/run.hpp"

namespace pliant::app {

/// Runs all walkers on `settings.threads` threads, up to eight at once on each. The result of a
/// walker depends only on the seed and its number. A walker that cannot be recorded stops; the
/// others continue. `last` receives the positions of a single walker. Throws the exception of the
/// first walker that failed, after all have ended.
std::vector<RunSummary> run_walkers(const RunSettings& settings, const Molecule& molecule,
                                    const Log& log, std::vector<Vec3>& last,
                                    LiveRun* live = nullptr);

}  // namespace pliant::app
