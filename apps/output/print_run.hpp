// SPDX-License-Identifier: MIT
// Prints the summary of pliant run as a table or as JSON.
#pragma once

#include <optional>
#include <vector>

#include "options/run_settings.hpp"
#include "output/guide_end.hpp"
#include "pliant/run/run.hpp"

namespace pliant::app {

/// The sums over walkers, and the worst residual of all.
RunSummary added_up(const std::vector<RunSummary>& summaries);

/// The exit code of the command: interrupted, unconverged or done.
int exit_code_of(const RunSummary& summary);

/// Prints what was taken from a force file, if there is one; as JSON if that was asked for.
void print_forces(const RunSettings& settings);

void print_run_table(const RunSettings& settings, const Framework& framework,
                     const std::vector<RunSummary>& summaries);
void print_run_json(const RunSettings& settings, const Framework& framework,
                    const std::vector<RunSummary>& summaries,
                    const std::vector<std::string>& warnings);
/// Prints the summary of serving clients.
void print_served(const ImdSummary& served);

/// Prints the summary with the results of the guide, and of serving if there was a server.
void print_run_json(const RunSettings& settings, const Framework& framework,
                    const std::vector<RunSummary>& summaries,
                    const std::vector<std::string>& warnings, const GuideEnd& end,
                    const std::optional<ImdSummary>& served);

}  // namespace pliant::app
