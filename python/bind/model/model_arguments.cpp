// SPDX-License-Identifier: MIT
#include "model/model_arguments.hpp"

#include <nanobind/stl/filesystem.h>

#include <algorithm>

#include "messages.hpp"
#include "model/molecular_contacts.hpp"
#include "pliant/base/error.hpp"
#include "pliant/base/system/path_text.hpp"

namespace pliant::python {
namespace {

constexpr const char* names_type = "collections.abc.Sequence[str]";

template <class T>
bool take_as(T& to, nb::handle value) {
  return !(std::is_same_v<T, double> && nb::isinstance<nb::str>(value)) && nb::try_cast(value, to);
}

/// Takes an argument of the same name as a member of PrepareOptions.
template <auto Member>
bool take_prepared(AskedModel& asked, nb::handle value) {
  return take_as(asked.options.prepare.*Member, value);
}

bool take_select(AskedModel& asked, nb::handle value) { return take_as(asked.select, value); }

bool take_assembly(AskedModel& asked, nb::handle value) {
  asked.assembly = nb::borrow(value);
  return value.is_none() || nb::isinstance<nb::str>(value) ||
         (nb::isinstance<nb::int_>(value) && !nb::isinstance<nb::bool_>(value));
}

bool take_cutoff(AskedModel& asked, nb::handle value) {
  return take_as(asked.options.hydrogen_bonds.cutoff, value);
}

bool take_more_contacts(AskedModel& asked, nb::handle value) {
  return take_as(asked.options.more_contacts, value);
}

bool take_contacts(AskedModel& asked, nb::handle value) {
  if (value.is_none()) return true;
  if (nb::isinstance<nb::str>(value) || nb::hasattr(value, "__fspath__"))
    asked.options.contacts_file = path_text(nb::cast<std::filesystem::path>(value));
  else
    asked.options.contacts = contacts_from(value);
  return true;
}

bool take_free_torsions(AskedModel& asked, nb::handle value) {
  bool is_free = false;
  if (!take_as(is_free, value)) return false;
  asked.options.torsions = !is_free;
  return true;
}

constexpr auto prepared = &ModelEntry::is_prepared;
constexpr auto held = &ModelEntry::has_contacts;

constexpr ModelArgument rows[] = {
    {"select", "str", "\"\"", "Selection of atoms to take, as for ``Structure.select``.",
     &take_select},
    {"assembly", "int | str | None", "None",
     "Biological assembly to build of the file at a path, as for ``read``.", &take_assembly},
    {"keep_waters", "bool", "False", "Leave waters in.",
     &take_prepared<&PrepareOptions::keep_waters>, prepared},
    {"keep", names_type, "()",
     "Molecules of crystallisation that stay, as ``[\"GOL\", \"SO4\"]`` or ``[\"all\"]``. Where "
     "there is a\n    protein or nucleic acid, they are left out, unless they are bonded to "
     "anything or hold a metal.",
     &take_prepared<&PrepareOptions::keep>, prepared},
    {"protonate", names_type, "()",
     "Forms of residues, as ``\"HIS57:HID\"`` or ``\"A:ASP25:ASH\"``; those of others follow "
     "from\n    hydrogens, names or a table for pH 7.",
     &take_prepared<&PrepareOptions::protonate>, prepared},
    {"floppy_below", "float", "0.0",
     "Residues whose B factor (a confidence, pLDDT) is below are floppy: they get no contacts; "
     "0: none.",
     &take_prepared<&PrepareOptions::floppy_below>, held},
    {"fill_side_chains", "bool", "False",
     "Build missing atoms of side chains by ideal geometry and the usual torsions that run least "
     "into\n    other atoms. A guess, which ``missing`` names.",
     &take_prepared<&PrepareOptions::fill_side_chains>, prepared},
    {"all_hydrogens", "bool", "False",
     "Place hydrogens on carbon by rule as well (ideal angles, methyls staggered), where a carbon "
     "of an\n    amino acid, cap or nucleotide has none.",
     &take_prepared<&PrepareOptions::all_hydrogens>, prepared},
    {"hbond_cutoff", "float", "-1.0", "kcal/mol: hydrogen bonds of no lower energy are left out.",
     &take_cutoff, held},
    {"contacts", "numpy.typing.ArrayLike | str | os.PathLike[str] | None", "None",
     "In place of those found: rows as ``contacts`` gives them, atoms of the prepared structure, "
     "or the\n    path of a table of them, as ``read_contacts`` reads it.",
     &take_contacts, held},
    {"more_contacts", names_type, "()",
     "Names in ``contact_kinds()`` of kinds to find besides the usual ones.", &take_more_contacts,
     held},
    {"free_torsions", "bool", "False",
     "When it is sampled, do not pull side chains towards staggered torsions (the rotamers of "
     "Lovell\n    et al., Proteins 40 (2000) 389), nor phi and psi back to the usual regions of "
     "the Ramachandran\n    plot.",
     &take_free_torsions, prepared},
};

/// Whether a value is what stands for nothing asked.
bool is_empty(nb::handle value) {
  return value.is_none() || value.is(nb::handle(Py_False)) ||
         (nb::hasattr(value, "__len__") && nb::len(value) == 0);
}

std::span<const ModelArgument> rows_up_to(std::string_view last) {
  const auto* row = std::find_if(std::begin(rows), std::end(rows),
                                 [&](const ModelArgument& one) { return one.name == last; });
  return {std::begin(rows), row + 1};
}

}  // namespace

std::span<const ModelArgument> preparation_arguments() { return rows_up_to("all_hydrogens"); }
std::span<const ModelArgument> contact_arguments() { return rows_up_to("more_contacts"); }
std::span<const ModelArgument> model_arguments() { return rows; }

std::string argument_texts(std::span<const ModelArgument> arguments) {
  std::string text;
  for (const ModelArgument& row : arguments)
    text += std::string(text.empty() ? "" : ", ") + row.name + ": " + row.type + " = " + row.usual;
  return text;
}

std::string argument_docs(std::span<const ModelArgument> arguments) {
  std::string text;
  for (const ModelArgument& row : arguments) {
    std::string type = row.type == names_type ? "sequence of str" : row.type;
    if (type.find(" | None") != type.npos)
      type = std::string_view(row.name) == "contacts" ? "array or path, optional"
                                                      : "int or str, optional";
    text += std::string(row.name) + " : " + type + "\n    " + row.doc + "\n";
  }
  return text;
}

AskedModel take_arguments(std::span<const ModelArgument> arguments, nb::dict given) {
  AskedModel asked;
  asked.options.log = asked.options.prepare.log = python_log();
  for (const ModelArgument& row : arguments) {
    if (!given.contains(row.name)) continue;
    const nb::object value = given[row.name];
    if (!row.take(asked, value)) continue;
    if (!is_empty(value)) asked.given.emplace_back(row.name);
    nb::del(given[row.name]);
  }
  return asked;
}

nb::object part_from(nb::handle argument, const AskedModel& asked) {
  return nb::module_::import_("pliant._trajectory.sources")
      .attr("part_of")(argument, asked.select, asked.assembly);
}

void refuse_for_built_model(const AskedModel& asked, std::string_view allowed) {
  for (const std::string& name : asked.given)
    if (name != allowed)
      throw OptionError(name + ": goes with a Structure; a MolecularModel is prepared already");
}

void refuse_unused(const AskedModel& asked, ModelKind kind) {
  for (const ModelArgument& row : rows) {
    if (row.use == nullptr || entry(kind).*row.use) continue;
    if (std::find(asked.given.begin(), asked.given.end(), row.name) == asked.given.end()) continue;
    std::string models_text;
    for (const ModelEntry& model : models())
      if (model.*row.use)
        models_text +=
            (models_text.empty() ? "" : " or ") + ("model=\"" + std::string(model.name) + "\"");
    throw OptionError(std::string(row.name) + ": goes with " + models_text + ", not \"" +
                      std::string(entry(kind).name) + "\"");
  }
}

}  // namespace pliant::python
