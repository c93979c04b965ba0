// SPDX-License-Identifier: MIT
// A job: what is to be done, as a value. From its rows come the options of the command, keywords of
// Python, the settings of the page, the parameters of a recorded file, which `--continue` reads
// back, and the shards of an ensemble.
#pragma once

#include <cstdint>
#include <functional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pliant/base/option_fields.hpp"
#include "pliant/jobs/asked/conformer_options.hpp"
#include "pliant/jobs/asked/guide_asked.hpp"
#include "pliant/jobs/asked/molecule_input.hpp"
#include "pliant/jobs/asked/output_options.hpp"
#include "pliant/jobs/asked/walkers_asked.hpp"
#include "pliant/run/run_options.hpp"
#include "pliant/sample/sample_fields.hpp"

namespace pliant {

/// What is asked for; each task heeds the groups that its rows name.
struct Job {
  std::string task = "sample";  ///< "sample", "run" or "conformers"
  MoleculeOptions molecule;     ///< input, bars, model
  SampleOptions sample = unset_sample_options();
  RunOptions run;
  WalkersAsked walkers;
  GuideAsked guide;
  ConformerOptions conformers;
  OutputOptions output;
  std::string go_on;     ///< trajectory that is continued; "": a new one
  bool is_live = false;  ///< clients follow a run and pull
  /// Names of the options that were given, which a file that is replayed does not decide.
  std::set<std::string, std::less<>> given = {};

  bool was_given(std::string_view name) const { return given.contains(name); }
};

/// A job whose options are as usual for that task. Throws OptionError for an unknown task.
Job usual_job(std::string_view task);

/// The rows of a task, in the order in which help lists them. Throws OptionError for an unknown
/// task.
std::span<const OptionRow<Job>> job_rows(std::string_view task);

/// Every option that files keep, by its path below /parameters.
std::vector<NamedParameter> parameters_of(const Job& job);

}  // namespace pliant
