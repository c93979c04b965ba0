// SPDX-License-Identifier: MIT
// The summary that pliant run ends with, as a table and as JSON.
#pragma once

#include <optional>
#include <vector>

#include "options/run_settings.hpp"
#include "pliant/run/run.hpp"

namespace pliant::app {

/// Sums over walkers; the worst residual is the worst of all.
RunSummary added_up(const std::vector<RunSummary>& summaries);

/// What the command ends with: interrupted, unconverged or done.
int exit_code_of(const RunSummary& summary);

/// What was taken from a force file, if there is one; as JSON if that was asked for.
void print_forces(const RunSettings& settings);

void print_run_table(const RunSettings& settings, const Framework& framework,
                     const std::vector<RunSummary>& summaries);
void print_run_json(const RunSettings& settings, const Framework& framework,
                    const std::vector<RunSummary>& summaries,
                    const std::vector<std::string>& warnings);
/// What came of serving its clients.
void print_served(const ImdSummary& served);

/// With what came of its guide, and of serving, if it was served.
void print_run_json(const RunSettings& settings, const Framework& framework,
                    const std::vector<RunSummary>& summaries,
                    const std::vector<std::string>& warnings, const GuideEnd& end,
                    const std::optional<ImdSummary>& served);

}  // namespace pliant::app
