// SPDX-License-Identifier: MIT
// The options of every subcommand with a molecule, and the molecule itself.
#pragma once

#include <optional>
#include <string>

#include "command_line.hpp"
#include "options/model_input.hpp"
#include "pliant/framework/framework.hpp"
#include "pliant/molecule/build_framework.hpp"
#include "pliant/molecule/structure/structure.hpp"
#include "pliant/text/file_text.hpp"

namespace pliant::app {

struct MoleculeOptions {
  std::string file;
  std::string format;
  std::int64_t model = 1;  ///< which model, frame or record
  /// MB; limit of the file, and of what it expands to
  std::int64_t max_input = usual_text / 1'000'000;
  std::string assembly;  ///< a biological assembly; "": the atoms as listed
  std::string select;    ///< selection of atoms; "": all
  std::string bars;      ///< "": those of the model, or bonds without a model
  std::string lengths = "geometry";
  std::string pin;
  bool guess_distances = true;
  bool may_be_cut = false;  ///< accept a molecule that a periodic box has cut, for a report
  ModelSettings kind;
};

struct Molecule {
  Structure structure;
  Framework framework;
  std::uint64_t fingerprint = 0;           ///< of the structure as read, before its model
  std::vector<std::string> left_out = {};  ///< by its model
};

/// The name or file of the bars: "bonds" by default, or the name of the model.
std::string bars_of(const MoleculeOptions& options);

/// Adds the options for the molecule and its model.
void add_molecule_options(CommandLine& line, MoleculeOptions& options);

/// Adds only the options for the file and how it is read.
void add_file_options(CommandLine& line, MoleculeOptions& options, bool takes_graphs = false);

/// Whether the file is a graph XML file, by its name.
bool is_graph(const MoleculeOptions& options);

/// Reads the file, perceives its bonds and selects atoms. Throws as the library does.
Structure read(const MoleculeOptions& options, const Log& log);

/// Calls read() and builds the framework. Throws as the library does.
Molecule load(const MoleculeOptions& options, const Log& log);

/// The files of these options: molecule, bars and contacts; "" for none.
std::vector<std::string> inputs_of(const MoleculeOptions& options);

}  // namespace pliant::app
