// SPDX-License-Identifier: MIT
// The model of a molecule, as a job asks for it: which one, its preparation and its contacts.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "pliant/base/log.hpp"
#include "pliant/base/option_fields.hpp"
#include "pliant/model/model.hpp"

namespace pliant {

/// The model `auto`: usual_model().
inline constexpr std::string_view automatic_model = "auto";

struct ModelAsked {
  std::string model;  ///< a name in models(), "auto", or "": none, for jobs that need none
  double hbond_cutoff = HydrogenBondOptions{}.cutoff;  ///< kcal/mol
  std::string contacts = {};       ///< file of contacts; "": they are searched for
  OptionNames more_contacts = {};  ///< kinds that are not usual
  bool keep_waters = false;
  OptionNames keep = {};
  bool fill_side_chains = false, all_hydrogens = false;
  OptionNames protonate = {};
  double floppy_below = 0.0;   ///< 0: no residue
  bool free_torsions = false;  ///< heeded by samples
};

/// A row, and what a model must have to heed the option: nothing, if null.
struct ModelField : OptionField<ModelAsked> {
  bool ModelEntry::*use = nullptr;
};

/// The table of these options; recorded below "model".
std::span<const ModelField> model_fields();

/// Throws OptionError if an option was given that a model of this kind has no use for; null: there
/// is no model. `dashes`: prefix of an option's name in messages: "--" for the command.
void check(const ModelAsked& asked, const ModelEntry* model, std::string_view dashes);

/// The kind of model that is asked for; `auto` is that of the structure. Throws OptionError for an
/// unknown name.
ModelKind kind_of_model(const ModelAsked& asked, const Structure& structure);

/// How such a model is built.
ModelOptions model_options_of(const ModelAsked& asked, ModelKind kind, const Log& log);

}  // namespace pliant
