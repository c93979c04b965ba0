// SPDX-License-Identifier: MIT
// The summary that pliant run ends with, as a table and as JSON.
#pragma once

#include <vector>

#include "pliant/run/run.hpp"
#include "run_settings.hpp"

namespace pliant::app {

/// Sums over walkers; the worst residual is the worst of all.
RunSummary added_up(const std::vector<RunSummary>& summaries);

/// What the command ends with: interrupted, unconverged or done.
int exit_code_of(const RunSummary& summary);

void print_run_table(const RunSettings& settings, const Framework& framework,
                     const std::vector<RunSummary>& summaries);
void print_run_json(const RunSettings& settings, const Framework& framework,
                    const std::vector<RunSummary>& summaries,
                    const std::vector<std::string>& warnings);
/// With what came of its guide.
void print_run_json(const RunSettings& settings, const Framework& framework,
                    const std::vector<RunSummary>& summaries,
                    const std::vector<std::string>& warnings, const GuideEnd& end);

}  // namespace pliant::app
