// SPDX-License-Identifier: MIT
// pliant contacts: what holds a molecule besides its bonds.
#include <fmt/format.h>

#include <map>

#include "command.hpp"
#include "messages.hpp"
#include "options/job_options.hpp"
#include "pliant/base/error.hpp"
#include "pliant/model/contacts/contact_file.hpp"

namespace pliant::app {
namespace {

struct ContactsSettings {
  InputOptions input;
  ModelAsked model;
  bool as_csv = false, as_json = false, verbose = false;
};

void add_options(CommandLine& line, ContactsSettings& settings) {
  add_input_options(line, settings.input, false);
  add_model_options(line, settings.model);
  line.start_group("Output");
  line.add_flag("--csv", settings.as_csv, "print a table that --contacts reads back");
  line.add_flag("--json", settings.as_json,
                "print one JSON object, which --contacts reads back as well");
  add_verbose(line, settings.verbose);
}

/// A row of the table; the middle one is the hydrogen.
void print_contact(const MolecularContact& contact, const AtomTable& atoms) {
  const bool has_hydrogen = contact.hydrogen != MolecularContact::none;
  fmt::print("{:<14} {:<16} {:<16} {:<16} {:>8.2f} {:>8.2f} {:>8.2f}\n", name(contact.kind),
             atoms.label(contact.a), has_hydrogen ? atoms.label(contact.hydrogen) : "",
             atoms.label(contact.b), contact.energy, contact.distance, contact.most);
}

void print_table(const std::vector<MolecularContact>& contacts, const AtomTable& atoms) {
  std::map<MolecularContactKind, std::size_t> counts;
  fmt::print("{:<14} {:<16} {:<16} {:<16} {:>8} {:>8} {:>8}\n", "kind", "donor, atom", "hydrogen",
             "acceptor, atom", "kcal/mol", "Angstrom", "at most");
  for (const MolecularContact& contact : contacts) {
    print_contact(contact, atoms);
    ++counts[contact.kind];
  }
  fmt::print("{} contacts", contacts.size());
  for (const auto& row : molecular_contact_kinds())
    if (counts[row.kind] > 0) fmt::print("; {} {}", row.name, counts[row.kind]);
  fmt::print("\n");
}

/// One usual kind a line.
std::string kinds_found() {
  std::string text;
  for (const auto& row : molecular_contact_kinds())
    if (row.is_usual) text += fmt::format("  {:<21} {}\n", row.plural, row.summary);
  return text;
}

}  // namespace

int command_contacts(const Arguments& arguments) {
  CommandLine line(
      "pliant contacts",
      "Lists what holds a molecule together besides its bonds:\n" + kinds_found() +
          "Polar hydrogens that the file lacks are added by geometric rules, always in the\n"
          "same way; stderr says which.");
  line.set_footer(
      "Examples:\n"
      "  pliant contacts protein.pdb\n"
      "  pliant contacts protein.pdb --csv > contacts.csv    # edit it, then\n"
      "  pliant run protein.pdb --model protein --contacts contacts.csv");
  ContactsSettings settings;
  add_options(line, settings);
  line.set_common({"--hbond-cutoff", "--more-contacts", "--select", "--csv", "--json"});
  if (const int code = line.parse(arguments); code >= 0) return code;
  if (settings.as_csv && settings.as_json) throw OptionError("--csv, --json: expected one of them");
  Messages messages(settings.as_json);
  const Log log = messages.log_of_model(settings.input.file, settings.verbose);
  const MolecularModel model = build_model(
      read_input(settings.input, log), model_options_of(settings.model, ModelKind::protein, log));
  messages.end_model(model.left_out);
  if (settings.as_csv) {
    fmt::print("{}", contacts_as_csv(model.contacts, model.structure));
  } else if (settings.as_json) {
    fmt::print("{}", contacts_as_json(model.contacts, model.structure));
  } else {
    print_table(model.contacts, model.structure.atoms);
  }
  return exit_ok;
}

}  // namespace pliant::app
