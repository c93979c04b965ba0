// SPDX-License-Identifier: MIT
// The options of a job on the command line, and what may be given once more when it goes on.
#pragma once

#include <functional>
#include <string>

#include "command_line.hpp"
#include "pliant/jobs/job.hpp"
#include "pliant/record/h5md/h5md_checkpoint_reader.hpp"

namespace pliant::app {

/// Adds the input and how it is read; how a molecule is prepared, without the kind of model.
void add_input_options(CommandLine& line, InputOptions& input, bool takes_graphs);
void add_model_options(CommandLine& line, ModelAsked& model);
/// Both, and bars.
void add_molecule_options(CommandLine& line, MoleculeOptions& molecule);

/// Adds the input and all rows of the job's task, and what every job prints.
void add_job_options(CommandLine& line, Job& job);

/// What a command prints, and whether it does anything.
struct Printing {
  std::string job_file;  ///< options as JSON; "": none
  bool dry_run = false, json = false, quiet = false, verbose = false;
};
/// Takes the options of a job from a JSON object of their names, where the command line does not
/// give them: {"task": "sample", "input": "protein.pdb", "frames": 400}. "" is no file, "-"
/// standard input. Throws InputError naming the file, and OptionError naming the option.
void take_job_file(CommandLine& line, Job& job, const std::string& file);

/// Notes in the job which of its options were given, on the command line or in its file.
void note_given(const CommandLine& line, Job& job);

/// Calls `work`, and returns its exit code. With a job file what is wrong is printed as JSON:
/// {"error": {"kind": "OptionError", "text": ...}}.
int with_errors_as_json(bool is_asked, const std::function<int()>& work);

void add_printing_options(CommandLine& line, Printing& printing);

/// Throws OptionError for the first option that was given and contradicts the file that the job
/// goes on from, or that makes no sense there. `parameters` are those of the command line.
void check_options_again(const CommandLine& line, const Job& given,
                         const std::vector<NamedParameter>& parameters,
                         const H5mdCheckpoint& recorded);

}  // namespace pliant::app
