// SPDX-License-Identifier: MIT
// Models of molecules: preparation, contacts, and the framework that they make.
#include <nanobind/stl/filesystem.h>

#include <algorithm>

#include "arrays.hpp"
#include "messages.hpp"
#include "model/model_arguments.hpp"
#include "model/molecular_contacts.hpp"
#include "molecule/structure.hpp"
#include "option_fields.hpp"
#include "pliant/base/choices.hpp"
#include "pliant/model/atoms/atom_graph.hpp"
#include "pliant/model/contacts/contact_file.hpp"
#include "pliant/model/model.hpp"
#include "tables.hpp"

namespace pliant::python {
namespace {

/// Raises TypeError for what is left of the arguments of a function of pliant.
void refuse_left(const char* function, const nb::object& molecule, const nb::dict& left) {
  refuse_unknown(nb::module_::import_("pliant._core").attr(function), nb::make_tuple(molecule),
                 left);
}

Preparation prepare_structure(const nb::object& molecule, bool add_hydrogens,
                              const nb::kwargs& more) {
  nb::dict given(more);
  AskedModel asked = take_arguments(ModelArguments::preparation, given);
  refuse_left("prepare", molecule, given);
  const nb::object part = part_from(molecule, asked);
  const auto& structure = nb::cast<const Structure&>(part);
  PrepareOptions options = model_options_of(asked.model, ModelKind::protein, python_log()).prepare;
  options.add_hydrogens = add_hydrogens;
  const nb::gil_scoped_release no_gil;
  return prepare(structure, options);
}

/// Without hydrogens, hydrogen bonds are not found.
bool lacks_hydrogens(const Structure& structure) {
  const auto& elements = structure.atoms.elements;
  return usual_model(structure) == ModelKind::protein &&
         std::find(elements.begin(), elements.end(), 1) == elements.end();
}

nb::object contacts_of(const nb::object& molecule, double hbond_cutoff,
                       std::vector<std::string> more_contacts) {
  ModelOptions options;
  const nb::object given = structure_from(molecule);
  const auto& structure = nb::cast<const Structure&>(given);
  if (lacks_hydrogens(structure))
    python_log().warn(
        "contacts: the molecule has no hydrogens, so no hydrogen bond is found: "
        "pliant.contacts(pliant.prepare(molecule).structure)");
  options.more_contacts = std::move(more_contacts);
  options.hydrogen_bonds.cutoff = hbond_cutoff;
  return contacts_to_python(find_contacts(structure, options));
}

MolecularModel model_of(const nb::object& molecule, const std::string& model,
                        const std::string& pin, const nb::kwargs& more) {
  nb::dict given(more);
  AskedModel asked = take_arguments(ModelArguments::all, given);
  refuse_left("build_model", molecule, given);
  ModelOptions options = options_of(asked, choose(models(), "model", model).kind);
  options.pin = pin;
  const nb::object part = part_from(molecule, asked);
  const auto& structure = nb::cast<const Structure&>(part);
  const nb::gil_scoped_release no_gil;
  return build_model(structure, options);
}

std::vector<std::int64_t> origins_of(const Preparation& self) {
  std::vector<std::int64_t> origins;
  for (std::uint32_t atom : self.origin)
    origins.push_back(atom == no_atom ? -1 : std::int64_t{atom});
  return origins;
}

constexpr const char* prepare_doc =
    R"(Makes a structure ready for a model: waters out, polar hydrogens in.

Parameters
----------
structure : Structure, path, Universe, AtomGroup or rdkit.Chem.Mol
    A molecule, as ``sample`` takes it.
add_hydrogens : bool
    Place polar hydrogens (on N, O, S) by rule where a residue has none.
)";

constexpr const char* prepare_refusals_doc =
    R"(
Raises
------
InputError
    Nothing but waters or CA atoms.
OptionError
    An unknown form, or one for a missing residue.
)";

constexpr const char* contacts_doc =
    R"(What holds a structure as it stands besides its bonds.

Parameters
----------
structure : Structure, path, Universe, AtomGroup or rdkit.Chem.Mol
    A molecule, as ``sample`` takes it, with polar hydrogens: ``prepare`` adds them.
hbond_cutoff : float
    kcal/mol: hydrogen bonds of no lower energy are left out.
more_contacts : sequence of str
    Names in ``contact_kinds()`` of kinds to find besides the usual ones.

Returns
-------
(C,) array with fields
    kind (a name in ``contact_kinds()``); a, b (donor and acceptor, or two atoms); hydrogen, base (-1:
    none); energy (kcal/mol); distance, least, most (a..b), hydrogen_most (H..acceptor), base_least,
    base_most (H..base), Angstrom.

Raises
------
OptionError
    An unknown kind.

Warns
-----
PliantWarning
    A protein or nucleic acid without hydrogens.
)";

constexpr const char* read_contacts_doc =
    R"(Reads a file of contacts, as ``pliant contacts`` writes it and you may have changed it.

Parameters
----------
path : str or path
    CSV.
structure : Structure, path, Universe, AtomGroup or rdkit.Chem.Mol
    The prepared structure whose atoms the file names: that of ``prepare``, or of a model.

Returns
-------
(C,) array
    As ``contacts`` gives it; for `contacts` of ``build_model`` and ``rigidity``.

Raises
------
InputError
    A line that cannot be read, or names an atom that is not there; the message names both.
FileError
    The file cannot be read.
)";

constexpr const char* build_doc =
    R"(The model of a molecule: structure, bars, limits and sterics.

Parameters
----------
structure : Structure, path, Universe, AtomGroup or rdkit.Chem.Mol
    A molecule, as ``sample`` takes it.
model : str
    A name in ``models()``: ``bonds``, ``angles``, ``molecule`` or ``protein``.
pin : str
    Selection of atoms that never move.
)";

constexpr const char* build_refusals_doc =
    R"(
Raises
------
InputError, OptionError
    As ``prepare`` and ``Structure.framework`` do;
    an unknown kind of contacts, kinds and `contacts`, or an argument of which the model has no use.
)";

void bind_preparation(nb::module_& module) {
  nb::class_<Preparation>(module, "Preparation", "A prepared structure, and what was done to it.")
      .def_ro("structure", &Preparation::structure, "The prepared structure.")
      .def_prop_ro(
          "origin", [](const Preparation& self) { return array_of(origins_of(self)); },
          nb::rv_policy::reference,
          "(N,) int64: index of each atom before preparation; -1: placed by rule.")
      .def_prop_ro(
          "floppy", [](const Preparation& self) { return mask_of(self.floppy); },
          nb::rv_policy::reference, "(R,) bool: residues whose contacts are left out; empty: none.")
      .def_ro("steps", &Preparation::steps, "What was done, line by line.")
      .def_ro("missing", &Preparation::missing, "What the structure lacks, line by line.")
      .def_ro("left_out", &Preparation::left_out, "What was taken out, as ``188 waters``.");
  const std::string signature = "def prepare(structure: " + std::string(any_molecule) +
                                ", *, add_hydrogens: bool = True, " +
                                argument_texts(ModelArguments::preparation) + ") -> Preparation";
  const std::string doc =
      prepare_doc + argument_docs(ModelArguments::preparation) + prepare_refusals_doc;
  module.def("prepare", &prepare_structure, "structure"_a.none(), nb::kw_only(),
             "add_hydrogens"_a = true, "options"_a, nb::sig(signature.c_str()), doc.c_str());
}

void bind_contact_kinds(nb::module_& module) {
  using Row = MolecularContactKindEntry;
  bind_row<Row>(module, "ContactKindEntry", "One row of the table of kinds of contacts.")
      .def_ro("singular", &Row::singular, "What text calls one.")
      .def_ro("plural", &Row::plural, "What text calls several.")
      .def_ro("slack", &Row::slack, "Angstrom.")
      .def_ro("bars", &Row::bars, "How many it counts as in the pebble game.")
      .def_ro("colour", &Row::colour, "What it is drawn in, as ``#3a9d8f``.")
      .def_prop_ro("has_hydrogen", &Row::has_hydrogen,
                   "Whether it has a hydrogen and an energy by which it is diluted.")
      .def_ro("is_usual", &Row::is_usual, "Whether it is found where nothing else is asked for.");
  module.def(
      "contact_kinds", [] { return rows_of(molecular_contact_kinds()); }, nb::rv_policy::reference,
      "The table of kinds of contacts that ``contacts`` finds.");
}

void bind_built_model(nb::module_& module) {
  bind_row<ModelEntry>(module, "ModelEntry", "One row of the table of models.")
      .def_ro("is_prepared", &ModelEntry::is_prepared, "Whether the structure is prepared first.")
      .def_ro("has_sterics", &ModelEntry::has_sterics, "Whether atoms keep their distance.")
      .def_ro("has_contacts", &ModelEntry::has_contacts, "Whether contacts hold.");
  module.def(
      "models", [] { return rows_of(models()); }, nb::rv_policy::reference,
      "The table of models that ``build_model`` knows.");
  nb::class_<MolecularModel>(module, "MolecularModel", "A molecule and its constraints.")
      .def_prop_ro(
          "kind", [](const MolecularModel& self) { return std::string(entry(self.kind).name); },
          "Name of the row of ``models()``.")
      .def_ro("structure", &MolecularModel::structure, "The structure made ready.")
      .def_ro("framework", &MolecularModel::framework,
              "Bars, limits (group k is contact k) and sterics.")
      .def_prop_ro(
          "positions",
          [](nb::handle_t<MolecularModel> self) {
            return view_of(nb::cast<MolecularModel&>(self).positions, self);
          },
          "(N, 3) float64 view, Angstrom: the start.")
      .def_prop_ro(
          "contacts", [](const MolecularModel& self) { return contacts_to_python(self.contacts); },
          nb::sig("def contacts(self) -> numpy.typing.NDArray[numpy.void]"),
          "(C,) what holds it besides bars and sterics, as ``contacts`` gives it.")
      .def_ro("notes", &MolecularModel::notes, "What was done and found, line by line.")
      .def_ro("missing", &MolecularModel::missing, "What the file lacks, line by line.")
      .def_ro("left_out", &MolecularModel::left_out, "What was taken out, as ``188 waters``.");
}

}  // namespace

void bind_model(nb::module_& module) {
  const ModelOptions usual;
  const std::string any = any_molecule;
  bind_preparation(module);
  bind_contact_kinds(module);
  bind_built_model(module);
  module.def("contacts", &contacts_of, "structure"_a.none(), nb::kw_only(),
             "hbond_cutoff"_a = usual.hydrogen_bonds.cutoff,
             "more_contacts"_a = std::vector<std::string>{},
             nb::sig(("def contacts(structure: " + any +
                      ", *, hbond_cutoff: float = -1.0, "
                      "more_contacts: collections.abc.Sequence[str] = ()) -> "
                      "numpy.typing.NDArray[numpy.void]")
                         .c_str()),
             contacts_doc);
  module.def(
      "read_contacts",
      [](const std::filesystem::path& path, const nb::object& molecule) {
        const nb::object given = structure_from(molecule);
        return contacts_to_python(read_contacts(path, nb::cast<const Structure&>(given)));
      },
      "path"_a, "structure"_a.none(),
      nb::sig(("def read_contacts(path: str | os.PathLike[str], structure: " + any +
               ") -> numpy.typing.NDArray[numpy.void]")
                  .c_str()),
      read_contacts_doc);
  const std::string signature = "def build_model(structure: " + any +
                                ", model: " + literal_type(names_of(models())) +
                                " = \"protein\", *, pin: str = \"\", " +
                                argument_texts(ModelArguments::all) + ") -> MolecularModel";
  const std::string doc = build_doc + argument_docs(ModelArguments::all) + build_refusals_doc;
  module.def("build_model", &model_of, "structure"_a.none(), "model"_a = "protein", nb::kw_only(),
             "pin"_a = "", "options"_a, nb::sig(signature.c_str()), doc.c_str());
}

}  // namespace pliant::python
