// SPDX-License-Identifier: MIT
// The job of pliant run, and what comes with its command line besides.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "options/imd_settings.hpp"
#include "options/job_options.hpp"
#include "pliant/perturb/force_files/force_events.hpp"
#include "pliant/perturb/force_files/force_header.hpp"

namespace pliant::app {

struct RunSettings {
  Job job = usual_job("run");
  Printing printing;
  ImdSettings imd;
  std::string force_text = {};                   ///< contents of the force file
  std::optional<ForceHeader> force_header = {};  ///< of that file
  /// Options taken from that file: name and value.
  std::vector<std::pair<std::string, std::string>> taken_from_forces = {};
  std::vector<ForceEvent> events;  ///< of a force file with events
};

void add_run_options(CommandLine& line, RunSettings& settings);

/// Sets the numbers of the walkers. Throws OptionError for options that exclude each other.
void number_walkers(const CommandLine& line, RunSettings& settings);

/// Sets the numbers of the walkers and the output names that the command line left open.
void settle(const CommandLine& line, RunSettings& settings);

/// Sets the other options left open: those of the force file, the ordering, the guide.
void complete(const CommandLine& line, RunSettings& settings, const Molecule& molecule);

/// Name of the output of a walker: `name` itself if there is only one walker and no shard, or if
/// all walkers share a trajectory.
std::string of_walker(const RunSettings& settings, const std::string& name, std::int64_t walker);
std::string output_of(const RunSettings& settings, std::int64_t walker);

/// Every option as stored below /parameters.
std::vector<NamedParameter> parameters_of(const RunSettings& settings, const Framework& framework,
                                          std::int64_t walker);

}  // namespace pliant::app
