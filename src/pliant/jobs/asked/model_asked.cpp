// SPDX-License-Identifier: MIT
#include "pliant/jobs/asked/model_asked.hpp"

#include <algorithm>

#include "pliant/base/choices.hpp"
#include "pliant/base/error.hpp"

namespace pliant {
namespace {

constexpr std::string_view group = "Model";

template <auto Member>
constexpr auto at = place_at<ModelAsked, Member>;

/// "cation_pi (LYS or ARG over ...)", one kind a line.
std::string_view more_contacts_summary() {
  static const std::string text = [] {
    std::string rows = "find contacts of these kinds besides the usual ones:";
    for (const MolecularContactKindEntry& row : molecular_contact_kinds())
      if (!row.is_usual)
        rows += "\n" + std::string(row.name) + " (" + std::string(row.summary) + ")";
    return rows;
  }();
  return text;
}

constexpr auto prepared = &ModelEntry::is_prepared;
constexpr auto held = &ModelEntry::has_contacts;

const ModelField table[] = {
    {{{.name = "model",
       .group = group,
       .summary = "what holds it together: bonds, angles, molecule (no overlaps) or protein\n"
                  "(contacts, too); auto: protein if there are residues, else molecule",
       .choices = [] { return names_of(models()); },
       .kind = "model",
       .is_optional = true,
       .in_python = "A name in ``models()``; ``auto``: ``protein`` where there are residues, else\n"
                    "``molecule``.",
       .automatic = automatic_model,
       .recorded = "model/kind"},
      at<&ModelAsked::model>}},
    {{{.name = "hbond_cutoff",
       .group = group,
       .summary = "leave out hydrogen bonds that are weaker than this energy, kcal/mol",
       .in_python = "kcal/mol: hydrogen bonds of no lower energy are left out."},
      at<&ModelAsked::hbond_cutoff>},
     held},
    {{{.name = "contacts",
       .group = group,
       .summary = "use the contacts in this file (as written by pliant contacts --csv or --json)",
       .kind = "FILE",
       .is_file = true,
       .in_python = "In place of those found: rows as ``contacts`` gives them, atoms of the "
                    "prepared\nstructure, or the path of a table of them, as ``read_contacts`` "
                    "reads it.",
       .type_in_python = "numpy.typing.ArrayLike | str | os.PathLike[str] | None"},
      at<&ModelAsked::contacts>},
     held},
    {{{.name = "more_contacts",
       .group = group,
       .summary = more_contacts_summary(),
       .in_python = "Names in ``contact_kinds()`` of kinds to find besides the usual ones."},
      at<&ModelAsked::more_contacts>},
     held},
    {{{.name = "keep_waters",
       .group = group,
       .summary = "do not remove waters",
       .in_python = "Leave waters in."},
      at<&ModelAsked::keep_waters>},
     prepared},
    {{{.name = "keep",
       .group = group,
       .summary = "keep these crystallisation additives, such as GOL,SO4, or all",
       .in_python = "Crystallisation additives to keep, as ``[\"GOL\", \"SO4\"]`` or "
                    "``[\"all\"]``. Where there\nis a protein or nucleic acid, they are left out, "
                    "unless they are bonded to anything\nor hold a metal."},
      at<&ModelAsked::keep>},
     prepared},
    {{{.name = "fill_side_chains",
       .group = group,
       .summary = "build missing side-chain atoms by rule (a guess: the data does not show them)",
       .in_python = "Build missing atoms of side chains by ideal geometry and the usual torsions "
                    "that run\nleast into other atoms. A guess, which ``missing`` names."},
      at<&ModelAsked::fill_side_chains>},
     prepared},
    {{{.name = "all_hydrogens",
       .group = group,
       .summary = "add hydrogens on carbon as well, and keep them clear of other atoms: for\n"
                  "starting MD; slower",
       .in_python = "Place hydrogens on carbon by rule as well (ideal angles, methyls staggered), "
                    "where a\ncarbon of an amino acid, cap or nucleotide has none."},
      at<&ModelAsked::all_hydrogens>},
     prepared},
    {{{.name = "protonate",
       .group = group,
       .summary = "protonation states, such as HIS57:HID,A:ASP25:ASH (default: from the hydrogens "
                  "and names in the file, else pH 7)",
       .in_python = "Forms of residues, as ``\"HIS57:HID\"`` or ``\"A:ASP25:ASH\"``; those of "
                    "others follow\nfrom hydrogens, names or a table for pH 7."},
      at<&ModelAsked::protonate>},
     prepared},
    {{{.name = "floppy_below",
       .group = group,
       .summary = "drop the contacts of residues with a confidence (pLDDT, in place of the\n"
                  "B factor) below this, such as 50",
       .range = Range::zero_or_more,
       .is_optional = true,
       .in_python = "Residues whose B factor (a confidence, pLDDT) is below are floppy: they get "
                    "no\ncontacts; 0: none."},
      at<&ModelAsked::floppy_below>},
     held},
    {{{.name = "free_torsions",
       .group = group,
       .summary =
           "do not pull side chains towards staggered torsions, nor phi and psi towards the\n"
           "allowed regions of the Ramachandran plot",
       .in_python = "When it is sampled, do not pull side chains towards staggered torsions (the\n"
                    "rotamers of Lovell et al., Proteins 40 (2000) 389), nor phi and psi back to "
                    "the usual\nregions of the Ramachandran plot."},
      at<&ModelAsked::free_torsions>},
     prepared},
};

/// "--model molecule or --model protein".
std::string models_with(bool ModelEntry::*use, std::string_view dashes) {
  std::string text;
  for (const ModelEntry& model : models()) {
    if (!(model.*use)) continue;
    const std::string name(model.name);
    text += (text.empty() ? "" : " or ") +
            (dashes.empty() ? "model=\"" + name + "\"" : "--model " + name);
  }
  return text;
}

}  // namespace

std::span<const ModelField> model_fields() { return table; }

void check(const ModelAsked& asked, const ModelEntry* model, std::string_view dashes) {
  ModelAsked usual;
  for (const ModelField& field : model_fields()) {
    check_option(field, field.place(places_of(asked)));
    if (field.use == nullptr || (model != nullptr && model->*field.use)) continue;
    if (option_text(field.place(places_of(asked))) == option_text(field.place(usual))) continue;
    const bool says_which = dashes.empty() && model != nullptr;
    throw OptionError(option_name(field.name, dashes) + ": goes with " +
                      models_with(field.use, dashes) +
                      (says_which ? ", not \"" + std::string(model->name) + "\"" : ""));
  }
}

ModelKind kind_of_model(const ModelAsked& asked, const Structure& structure) {
  if (asked.model == automatic_model) return usual_model(structure);
  return choose(models(), "model", asked.model).kind;
}

ModelOptions model_options_of(const ModelAsked& asked, ModelKind kind, const Log& log) {
  ModelOptions options;
  options.kind = kind;
  options.prepare.keep_waters = asked.keep_waters;
  options.prepare.keep = asked.keep;
  options.prepare.fill_side_chains = asked.fill_side_chains;
  options.prepare.all_hydrogens = asked.all_hydrogens;
  options.prepare.protonate = asked.protonate;
  options.prepare.floppy_below = asked.floppy_below;
  options.hydrogen_bonds.cutoff = asked.hbond_cutoff;
  options.torsions = !asked.free_torsions;
  options.contacts_file = asked.contacts;
  options.more_contacts = asked.more_contacts;
  options.log = options.prepare.log = log;
  return options;
}

}  // namespace pliant
