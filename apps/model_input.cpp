// SPDX-License-Identifier: MIT
#include "model_input.hpp"

#include "pliant/base/choices.hpp"

namespace pliant::app {

void add_model_options(CommandLine& line, ModelSettings& settings) {
  line.start_group("Model");
  line.add_real("--hbond-cutoff", settings.hbond_cutoff, Range::any,
                "kcal/mol: hydrogen bonds of no lower energy are left out");
  line.add_text("--contacts", settings.contacts, "FILE",
                "contacts as pliant contacts --csv writes them, in place of those found");
  line.add_flag("--keep-waters", settings.keep_waters, "do not take waters out");
  line.add_names("--protonate", settings.protonate, "as hydrogens, names or pH 7 say",
                 "forms of residues, as HIS57:HID or A:ASP25:ASH");
  line.add_flag("--floppy", settings.floppy,
                "leave out contacts of residues with a confidence (pLDDT) below 50");
}

void check_without_model(const ModelSettings& settings) {
  const ModelSettings usual;
  const char* given = settings.hbond_cutoff != usual.hbond_cutoff ? "--hbond-cutoff"
                      : !settings.contacts.empty()                ? "--contacts"
                      : settings.keep_waters                      ? "--keep-waters"
                      : !settings.protonate.empty()               ? "--protonate"
                      : settings.floppy                           ? "--floppy"
                                                                  : nullptr;
  if (given != nullptr)
    throw OptionError(std::string(given) + ": goes with --model molecule or --model protein");
}

ModelOptions model_options_of(const ModelSettings& settings, const Log& log) {
  ModelOptions options;
  if (!settings.name.empty()) options.kind = choose(models(), "model", settings.name).kind;
  options.prepare.keep_waters = settings.keep_waters;
  options.prepare.protonate = settings.protonate;
  options.prepare.floppy_below = settings.floppy ? disordered_below : 0.0;
  options.hydrogen_bonds.cutoff = settings.hbond_cutoff;
  options.contacts_file = settings.contacts;
  options.log = log;
  return options;
}

}  // namespace pliant::app
