// SPDX-License-Identifier: MIT
// The options of pliant run, the library's options that they give, and their record.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "commit_settings.hpp"
#include "options/guide_settings.hpp"
#include "options/imd_settings.hpp"
#include "options/molecule_input.hpp"
#include "pliant/perturb/force_files/force_events.hpp"
#include "pliant/perturb/force_files/force_header.hpp"
#include "pliant/record/h5md/h5md_recorder.hpp"
#include "pliant/run/run.hpp"

namespace pliant::app {

struct RunSettings {
  MoleculeOptions molecule;
  RunOptions run;
  GuideSettings guide;
  H5mdOptions record;
  std::string save;  ///< selection of the atoms to record; "": all
  ImdSettings imd;
  std::string go_on;             ///< trajectory whose run is continued; "": a new run
  std::string output;            ///< "": the input's name with .h5md, in the current folder
  std::string topology;          ///< sidecar PDB; "": the output's name with .pdb; "none": none
  std::string forces;            ///< force file to replay; "": none
  bool override_forces = false;  ///< the command line overrides the force file
  std::string force_text = {};   ///< contents of that file
  std::optional<ForceHeader> force_header = {};  ///< of that file
  /// Options taken from that file: name and value.
  std::vector<std::pair<std::string, std::string>> taken_from_forces = {};
  std::vector<ForceEvent> events;  ///< of a force file with events
  std::string record_forces;       ///< force file to write; "": none
  std::string ordering;            ///< ordering file that replaces a technique's ordering; "": none
  std::string shard;  ///< "FIRST..LAST", numbers of walkers, in place of `walkers`; or ""
  std::int64_t first_walker = 0;
  std::int64_t walkers = 1;  ///< from first_walker on
  CommitSettings commits;
  bool one_file = false;     ///< all frames go into one trajectory, one walker after another
  std::int64_t threads = 0;  ///< 0: one for each core
  bool dry_run = false;
  bool json = false;
  bool quiet = false;
  bool verbose = false;
};

void add_run_options(CommandLine& line, RunSettings& settings);

/// Sets the numbers of the walkers.
void number_walkers(const CommandLine& line, RunSettings& settings);

/// Sets the numbers of the walkers and the output names that the command line left open.
void name_outputs(const CommandLine& line, RunSettings& settings);

/// Sets the other options left open: those of the force file, the ordering, the guide.
void complete(const CommandLine& line, RunSettings& settings, const Molecule& molecule);

/// Whether there are several walkers, or a shard of several.
bool is_ensemble(const RunSettings& settings);

/// Name of the output of a walker: `name` itself if there is only one walker and no shard, or if
/// all walkers share a trajectory.
std::string of_walker(const RunSettings& settings, const std::string& name, std::int64_t walker);
std::string output_of(const RunSettings& settings, std::int64_t walker);

/// Every option as stored below /parameters.
std::vector<NamedParameter> parameters_of(const RunSettings& settings, const Framework& framework,
                                          std::int64_t walker);

}  // namespace pliant::app
