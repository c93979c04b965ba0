// SPDX-License-Identifier: MIT
// Prints the result of pliant sample.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "options/job_options.hpp"
#include "pliant/jobs/sample_job.hpp"

namespace pliant::app {

/// The residues that frames of sampler pocket open or close; none of other samplers.
std::vector<std::string> pocket_of(const Job& job, const SampledSystem& system);

/// Prints a table, JSON or nothing.
void print_sample(const Printing& printing, const Job& job, const SampledSystem& system,
                  const SampleSummary& summary, const std::vector<std::string>& warnings);

/// The exit code of the command.
int exit_code_of(const SampleSummary& summary);

}  // namespace pliant::app
