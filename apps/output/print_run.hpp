// SPDX-License-Identifier: MIT
// Prints the summary of pliant run as a table or as JSON.
#pragma once

#include <optional>
#include <vector>

#include "options/imd_settings.hpp"
#include "options/job_options.hpp"
#include "output/guide_end.hpp"
#include "pliant/jobs/replayed_header.hpp"
#include "pliant/run/run.hpp"

namespace pliant::app {

/// The sums over walkers, and the worst residual of all.
RunSummary added_up(const std::vector<RunSummary>& summaries);

/// The exit code of the command: interrupted, unconverged or done.
int exit_code_of(const RunSummary& summary);

/// What is printed of a run. All must outlive it.
struct RunReport {
  const Printing& printing;
  const Job& job;
  const Framework& framework;
  const ReplayedForces& replayed;
};

/// Prints what was taken from a force file, if there is one; as JSON if that was asked for.
void print_forces(const Printing& printing, const Job& job, const ReplayedForces& replayed);

/// Prints the summary as was asked for, with what became of the guide and of serving if there were
/// any.
void print_run(const RunReport& report, const std::vector<RunSummary>& summaries,
               const std::vector<std::string>& warnings, const GuideEnd* end = nullptr,
               const std::optional<ImdSummary>& served = {});

}  // namespace pliant::app
