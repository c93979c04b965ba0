// SPDX-License-Identifier: MIT
// The options that every subcommand with a molecule takes, and the molecule that they mean.
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
  std::int64_t model = 1;                           ///< which model, frame or record
  std::int64_t max_input = usual_text / 1'000'000;  ///< MB of the file, and of what it expands to
  std::string assembly;                             ///< a biological one; "": as the file is
  std::string select;                               ///< atoms to take; "": all
  std::string bars;  ///< "": as the kind of model says, bonds if that is left open
  std::string lengths = "geometry";
  std::string pin;
  bool guess_distances = true;
  bool may_be_cut = false;  ///< take a molecule that a periodic box has cut, to tell of it
  ModelSettings kind;
};

struct Molecule {
  Structure structure;
  Framework framework;
  std::uint64_t fingerprint = 0;  ///< of the structure as it was read, before its model
};

/// The name or file of the bars: "bonds" where nothing was asked for, else the kind of model.
std::string bars_of(const MoleculeOptions& options);

/// What tells the molecule and the kind of its model.
void add_molecule_options(CommandLine& line, MoleculeOptions& options);

/// Those of them that tell which file and how it is read.
void add_file_options(CommandLine& line, MoleculeOptions& options);

/// Reads the file, perceives its bonds, takes the atoms that were selected. Throws as the library
/// does.
Structure read(const MoleculeOptions& options, const Log& log);

/// As read(), and builds its framework. Throws as the library does.
Molecule load(const MoleculeOptions& options, const Log& log);

/// The files that telling the molecule takes: itself, its bars, its contacts; "" where there is
/// none.
std::vector<std::string> inputs_of(const MoleculeOptions& options);

}  // namespace pliant::app
