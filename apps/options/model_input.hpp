// SPDX-License-Identifier: MIT
// The options of the model of a molecule: its preparation and its contacts.
#pragma once

#include <string>
#include <vector>

#include "command_line.hpp"
#include "pliant/base/parameter.hpp"
#include "pliant/model/model.hpp"

namespace pliant::app {

struct ModelSettings {
  std::string name;  ///< of a row of models(); "": not given
  double hbond_cutoff = -1.0;
  bool keep_waters = false, fill_side_chains = false, all_hydrogens = false, floppy = false;
  bool has_torsions = false;  ///< the command uses torsion preferences
  bool free_torsions = false;
  std::vector<std::string> keep, protonate;
  std::string contacts;                    ///< file of contacts; "": they are searched for
  std::vector<std::string> more_contacts;  ///< kinds that are not usual
};

/// Adds the options of preparation and contacts.
void add_model_options(CommandLine& line, ModelSettings& settings);

/// Adds the option of commands that use torsion preferences.
void add_torsion_option(CommandLine& line, ModelSettings& settings);

/// Throws OptionError if an option was given that does not apply to the model, or without a model.
void check(const ModelSettings& settings);

/// The settings as stored below /parameters; none without a model.
std::vector<NamedParameter> parameters_of(const ModelSettings& settings);

ModelOptions model_options_of(const ModelSettings& settings, const Log& log);

}  // namespace pliant::app
