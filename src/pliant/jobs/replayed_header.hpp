// SPDX-License-Identifier: MIT
// pliant run --forces: compares what the force file was made for with what is asked for.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pliant/base/log.hpp"
#include "pliant/jobs/job.hpp"
#include "pliant/perturb/force_files/force_events.hpp"
#include "pliant/perturb/force_files/force_header.hpp"

namespace pliant {

/// A force file that is replayed.
struct ReplayedForces {
  std::string text;                                        ///< all of the file
  std::optional<ForceHeader> header;                       ///< none: no file
  std::vector<std::pair<std::string, std::string>> taken;  ///< options from it: name, value
  std::vector<ForceEvent> events;                          ///< of a file with events
};

/// Reads the force file that the job names, and takes from its header the options of the molecule
/// that are not given. Throws OptionError if both differ, and InputError as read_force_header()
/// does.
void take_force_header(Job& job, ReplayedForces& replayed);

/// Throws InputError if the file was made for another structure or framework. Warns if a file does
/// not say what it was made for.
void check_force_header(const Job& job, const ReplayedForces& replayed, const RunSubject& subject,
                        const Log& log);

/// Throws OptionError where an option, `given`, contradicts `made`, that of the force file (such as
/// "with --model protein").
[[noreturn]] void refuse_contradiction(const Job& job, const std::string& given,
                                       const std::string& made);

}  // namespace pliant
