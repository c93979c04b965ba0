// SPDX-License-Identifier: MIT
#include "options/model_input.hpp"

#include <filesystem>

#include "pliant/base/choices.hpp"
#include "pliant/base/system/path_text.hpp"

namespace pliant::app {
namespace {

/// "cation_pi (LYS or ARG over ...)", one kind a line.
std::string unusual_contacts() {
  std::string text;
  for (const MolecularContactKindEntry& row : molecular_contact_kinds())
    if (!row.is_usual) text += "\n" + std::string(row.name) + " (" + std::string(row.summary) + ")";
  return text;
}

std::string comma_separated(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ",") + word;
  return text;
}

}  // namespace

void add_model_options(CommandLine& line, ModelSettings& settings) {
  line.start_group("Model");
  line.add_real("--hbond-cutoff", settings.hbond_cutoff, Range::any,
                "leave out hydrogen bonds that are weaker than this energy, kcal/mol");
  line.add_text("--contacts", settings.contacts, "FILE",
                "use the contacts in this file (as written by pliant contacts --csv or --json)");
  line.add_names("--more-contacts", settings.more_contacts, "",
                 "find contacts of these kinds besides the usual ones:" + unusual_contacts());
  line.add_flag("--keep-waters", settings.keep_waters, "do not remove waters");
  line.add_names("--keep", settings.keep, "",
                 "keep these crystallisation additives, such as GOL,SO4, or all");
  line.add_flag("--fill-side-chains", settings.fill_side_chains,
                "build missing side-chain atoms by rule (a guess: the data does not show them)");
  line.add_flag("--all-hydrogens", settings.all_hydrogens,
                "add hydrogens on carbon as well, and keep them clear of other atoms: for\n"
                "starting MD; slower");
  line.add_names("--protonate", settings.protonate, "",
                 "protonation states, such as HIS57:HID,A:ASP25:ASH (default: from the hydrogens "
                 "and names in the file, else pH 7)");
  line.add_flag("--floppy", settings.floppy,
                "drop the contacts of residues with a confidence (pLDDT) below 50");
}

void add_torsion_option(CommandLine& line, ModelSettings& settings) {
  line.add_flag("--free-torsions", settings.free_torsions,
                "do not pull side chains towards staggered torsions, nor phi and psi towards the\n"
                "allowed regions of the Ramachandran plot");
}

void check(const ModelSettings& settings) {
  const ModelSettings usual;
  const ModelEntry* model = nullptr;
  if (!settings.name.empty()) model = &choose(models(), "model", settings.name);
  const auto refuse = [](bool is_given, const char* option, const char* expected) {
    if (is_given) throw OptionError(std::string(option) + ": goes with " + expected);
  };
  if (model == nullptr || !model->is_prepared) {
    const char* expected = "--model molecule or --model protein";
    refuse(settings.keep_waters, "--keep-waters", expected);
    refuse(!settings.keep.empty(), "--keep", expected);
    refuse(settings.fill_side_chains, "--fill-side-chains", expected);
    refuse(settings.all_hydrogens, "--all-hydrogens", expected);
    refuse(settings.free_torsions, "--free-torsions", expected);
    refuse(!settings.protonate.empty(), "--protonate", expected);
  }
  if (model == nullptr || !model->has_contacts) {
    refuse(settings.hbond_cutoff != usual.hbond_cutoff, "--hbond-cutoff", "--model protein");
    refuse(!settings.contacts.empty(), "--contacts", "--model protein");
    refuse(!settings.more_contacts.empty(), "--more-contacts", "--model protein");
    refuse(settings.floppy, "--floppy", "--model protein");
  }
}

std::vector<NamedParameter> parameters_of(const ModelSettings& settings) {
  if (settings.name.empty()) return {};
  return {{"model/kind", settings.name},
          {"model/hbond_cutoff", settings.hbond_cutoff},
          {"model/keep_waters", settings.keep_waters},
          {"model/keep", comma_separated(settings.keep)},
          {"model/fill_side_chains", settings.fill_side_chains},
          {"model/all_hydrogens", settings.all_hydrogens},
          {"model/protonate", comma_separated(settings.protonate)},
          {"model/floppy", settings.floppy},
          {"model/contacts", path_text(path_of(settings.contacts).filename())},
          {"model/more_contacts", comma_separated(settings.more_contacts)}};
}

ModelOptions model_options_of(const ModelSettings& settings, const Log& log) {
  ModelOptions options;
  if (!settings.name.empty()) options.kind = choose(models(), "model", settings.name).kind;
  options.prepare.keep_waters = settings.keep_waters;
  options.prepare.keep = settings.keep;
  options.prepare.fill_side_chains = settings.fill_side_chains;
  options.prepare.all_hydrogens = settings.all_hydrogens;
  options.prepare.protonate = settings.protonate;
  options.torsions = settings.has_torsions && !settings.free_torsions;
  options.prepare.floppy_below = settings.floppy ? disordered_below : 0.0;
  options.hydrogen_bonds.cutoff = settings.hbond_cutoff;
  options.contacts_file = settings.contacts;
  options.more_contacts = settings.more_contacts;
  options.log = log;
  return options;
}

}  // namespace pliant::app
