// SPDX-License-Identifier: MIT
// The options of pliant sample, the library's options that they give, and their record.
#pragma once

#include <string>
#include <vector>

#include "commit_settings.hpp"
#include "options/molecule_input.hpp"
#include "pliant/base/parameter.hpp"
#include "pliant/jobs/sample_task.hpp"
#include "pliant/model/amplitude.hpp"
#include "pliant/model/model.hpp"
#include "pliant/record/h5md/h5md_recorder.hpp"
#include "pliant/sample/sample_fields.hpp"

namespace pliant::app {

struct SampleSettings {
  MoleculeOptions molecule;
  std::string model = "auto";  ///< a name in models(), or "auto"
  SampleOptions sample = unset_sample_options();
  std::string amplitude;             ///< as given: a number, a word or a file; "": the default
  AmplitudeChoice chosen_amplitude;  ///< set by asked_of()
  H5mdOptions record;
  std::string save;  ///< selection of the atoms to record; "": all
  CommitSettings commits;
  std::string go_on;     ///< trajectory whose sample is continued; "": a new one
  std::string output;    ///< "": the input's name with .h5md, in the current folder
  std::string topology;  ///< sidecar PDB; "": the output's name with .pdb; "none": none
  bool show = false;     ///< on the page of `pliant play`, once they are there
  bool dry_run = false;
  bool json = false;
  bool quiet = false;
  bool verbose = false;
};

void add_sample_options(CommandLine& line, SampleSettings& settings);

/// Sets what the command line left open: names of outputs.
void complete(SampleSettings& settings);

/// Reads the file, perceives its bonds and builds its model, whose name is put into `settings`.
/// Throws as the library does.
MolecularModel load_model(SampleSettings& settings, const Log& log);

/// The task's options; the amplitude is put into `settings`. Throws as the library does.
SampleAsked asked_of(SampleSettings& settings, const MolecularModel& model, const Log& log);

/// The files that are read: those of the molecule, and that of the amplitude; "" for none.
std::vector<std::string> inputs_of(const SampleSettings& settings);

/// Every option as stored below /parameters.
std::vector<NamedParameter> parameters_of(const SampleSettings& settings);

}  // namespace pliant::app
