// SPDX-License-Identifier: MIT
// The options of pliant run, what they mean to the library, and how they are recorded.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

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
  std::string go_on;             ///< trajectory whose run goes on; "": a new run
  std::string output;            ///< "": the input's name with .h5md, in the current folder
  std::string topology;          ///< sidecar PDB; "": the output's name with .pdb; "none": none
  std::string forces;            ///< force file to replay; "": none
  bool override_forces = false;  ///< the command line holds where the two contradict
  std::string force_text = {};   ///< what that file holds
  std::optional<ForceHeader> force_header = {};  ///< of that file
  /// Options that hold because that file says so: name and value.
  std::vector<std::pair<std::string, std::string>> taken_from_forces = {};
  std::vector<ForceEvent> events;  ///< of such a file that has events
  std::string record_forces;       ///< force file to write; "": none
  std::string ordering;            ///< ordering file in place of a technique's ordering; "": none
  std::string shard;  ///< "FIRST..LAST", walkers by number, in place of `walkers`; or ""
  std::int64_t first_walker = 0;
  std::int64_t walkers = 1;  ///< from the first one on
  bool one_file = false;     ///< their frames, one walker after another, go into one trajectory
  std::int64_t threads = 0;  ///< 0: as many as there are cores
  bool dry_run = false;
  bool json = false;
  bool quiet = false;
};

void add_run_options(CommandLine& line, RunSettings& settings);

/// Fills in the numbers of the walkers.
void number_walkers(const CommandLine& line, RunSettings& settings);

/// Fills in the numbers of the walkers and the output names that the command line left open.
void name_outputs(const CommandLine& line, RunSettings& settings);

/// Fills in what else it left open: settings of the force file, the ordering, the guide.
void complete(const CommandLine& line, RunSettings& settings, const Molecule& molecule);

/// Whether there are several walkers, or a part of several.
bool is_ensemble(const RunSettings& settings);

/// The outputs of walkers [first_walker, first_walker + walkers): `name` itself if there is but one
/// walker, and no shard was asked for, and the trajectory's name if there is one for all.
std::string of_walker(const RunSettings& settings, const std::string& name, std::int64_t walker);
std::string output_of(const RunSettings& settings, std::int64_t walker);

/// Every option as it is stored below /parameters.
std::vector<NamedParameter> parameters_of(const RunSettings& settings, const Framework& framework,
                                          std::int64_t walker);

}  // namespace pliant::app
