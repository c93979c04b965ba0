// SPDX-License-Identifier: MIT
// The options that every subcommand with a molecule takes, and the molecule that they mean.
#pragma once

#include <optional>
#include <string>

#include "command_line.hpp"
#include "pliant/framework/framework.hpp"
#include "pliant/molecule/build_framework.hpp"
#include "pliant/molecule/structure/structure.hpp"

namespace pliant::app {

struct MoleculeOptions {
  std::string file;
  std::string format;
  std::int64_t model = 1;
  std::string bars = "bonds";
  std::string lengths = "geometry";
  std::string pin;
  bool guess_distances = true;
};

struct Molecule {
  Structure structure;
  Framework framework;
};

void add_molecule_options(CommandLine& line, MoleculeOptions& options);

/// Reads the file, perceives its bonds, builds its framework. Throws as the library does.
Molecule load(const MoleculeOptions& options, const Log& log);

/// Throws OptionError if both names lead to one file, whatever links there are.
void refuse_same_file(const std::string& input, const std::string& output);

}  // namespace pliant::app
