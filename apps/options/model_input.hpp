// SPDX-License-Identifier: MIT
// The options of the model of a molecule: how it is made ready and which contacts it has.
#pragma once

#include <string>
#include <vector>

#include "command_line.hpp"
#include "pliant/base/parameter.hpp"
#include "pliant/model/model.hpp"

namespace pliant::app {

struct ModelSettings {
  std::string name;  ///< of a row of models(); "": none was asked for
  double hbond_cutoff = -1.0;
  bool keep_waters = false, fill_side_chains = false, all_hydrogens = false, floppy = false;
  bool has_torsions = false;  ///< whether the command heeds torsion preferences
  bool free_torsions = false;
  std::vector<std::string> protonate;
  std::string contacts;  ///< file to read them from; "": found
};

/// Options of preparation, and which contacts there are.
void add_model_options(CommandLine& line, ModelSettings& settings);

/// The option of the command that heeds torsion preferences.
void add_torsion_option(CommandLine& line, ModelSettings& settings);

/// Throws OptionError if an option was given that the model, or no model at all, does not know.
void check(const ModelSettings& settings);

/// The settings as they are stored below /parameters; none where no model was asked for.
std::vector<NamedParameter> parameters_of(const ModelSettings& settings);

ModelOptions model_options_of(const ModelSettings& settings, const Log& log);

}  // namespace pliant::app
