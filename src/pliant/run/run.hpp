// SPDX-License-Identifier: MIT
// The run: a Motion, step after step, whose frames go to observers.
#pragma once

#include <span>
#include <vector>

#include "pliant/run/run_options.hpp"
#include "pliant/run/run_summary.hpp"

namespace pliant {

/// Throws OptionError naming the option, its value and its range.
void check(const RunOptions& options);

/// Moves `state`. Step 0 (the start, resolved first if it is broken) is shown, then every
/// `every`-th step and the last. A step that does not converge is shown and counted as such, and
/// the run continues; with Stop::not_finite its push is taken back. Throws OptionError, InputError
/// (positions that cannot carry the framework), and whatever an observer throws.
RunSummary run(const Framework& framework, State& state, const RunOptions& options,
               const std::vector<Observer>& observers);

/// Runs walkers in step with each other, so that those whose pushes moved all joints are resolved
/// together (WalkerResolver). Each walker has the result of run() alone, bit by bit; the seconds of
/// its summary are its share. A walker that is asked to stop stops alone. Throws as run(); each
/// walker then ends with its last whole step. With limits or sterics a step of several walkers
/// looks at all joints; run_ensemble() runs those one after another.
std::vector<RunSummary> run_walkers(const Framework& framework, std::span<WalkerRun> walkers,
                                    const RunOptions& options);

}  // namespace pliant
