// SPDX-License-Identifier: MIT
// The options of pliant sample, what they mean to the library, and how they are recorded.
#pragma once

#include <string>
#include <vector>

#include "molecule_input.hpp"
#include "pliant/base/parameter.hpp"
#include "pliant/model/amplitude.hpp"
#include "pliant/model/model.hpp"
#include "pliant/record/h5md/h5md_recorder.hpp"
#include "pliant/sample/sample.hpp"

namespace pliant::app {

struct SampleSettings {
  MoleculeOptions molecule;
  std::string model = "auto";  ///< a name in models(), or what fits the file
  SampleOptions sample;
  std::string amplitude;             ///< as given: a number, a word or a file; "": the usual one
  AmplitudeChoice chosen_amplitude;  ///< see choose_amplitude()
  std::int64_t threads = 0;          ///< 0: as many as there are cores
  H5mdOptions record;
  std::string save;      ///< selection of the atoms to record; "": all
  std::string go_on;     ///< trajectory whose sample goes on; "": a new one
  std::string output;    ///< "": the input's name with .h5md, in the current folder
  std::string topology;  ///< sidecar PDB; "": the output's name with .pdb; "none": none
  bool dry_run = false;
  bool json = false;
  bool quiet = false;
};

void add_sample_options(CommandLine& line, SampleSettings& settings);

/// Fills in what the command line left open: names of outputs, threads.
void complete(SampleSettings& settings);

/// Threads to share the frames.
int threads_of(const SampleSettings& settings);

/// Reads the file, perceives its bonds, builds its model, whose kind is then in `settings`. Throws
/// as the library does.
MolecularModel load_model(SampleSettings& settings, const Log& log);

/// The way to move, where the option leaves it open; it is then in `settings`. Throws OptionError
/// for options that do not go with it.
void choose_sampler(SampleSettings& settings, const MolecularModel& model);

/// How far frames go, from the option and what is sampled; it is then in `settings`. Throws as the
/// library does.
void choose_amplitude(SampleSettings& settings, const MolecularModel& model, const Log& log);

/// The files that are read: those of the molecule, and that of the amplitude; "" where there is
/// none.
std::vector<std::string> inputs_of(const SampleSettings& settings);

/// The nodes of the elastic network of a model. Throws InputError where there are fewer than two.
NetworkNodes nodes_of(const MolecularModel& model);

/// Every option as it is stored below /parameters.
std::vector<NamedParameter> parameters_of(const SampleSettings& settings);

}  // namespace pliant::app
