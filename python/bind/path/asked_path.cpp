// SPDX-License-Identifier: MIT
#include "path/asked_path.hpp"

#include <string>
#include <utility>
#include <vector>

#include "molecule/structure.hpp"
#include "option_fields.hpp"
#include "pliant/base/choices.hpp"

namespace pliant::python {
namespace {

/// Takes the options from `given`, and leaves what is another argument.
AskedPath asked_from(nb::dict given) {
  AskedPath asked;
  take_values(path_fields(), given, asked);
  check(asked);
  asked.molecule = take_arguments(ModelArguments::path, given);
  std::string& name = asked.molecule.model.model;
  if (name == automatic_model) name = AskedPath().molecule.model.model;  // a path has residues
  asked.model = options_of(asked.molecule, choose(models(), "model", name).kind);
  return asked;
}

void make_options(AskedPath* self, const nb::kwargs& named) {
  nb::dict given(named);
  AskedPath asked = asked_from(given);
  refuse_unknown(nb::type<AskedPath>().attr("__init__"), nb::make_tuple(nb::none()), given);
  new (self) AskedPath(std::move(asked));
}

nb::object start_of(const AskedPath& self, nb::handle molecule) {
  return part_from(molecule, self.molecule);
}

/// What says which part of a file it is, is of the start alone; the end is matched to it.
nb::object end_of(const AskedPath& self, nb::handle molecule) {
  AskedModel asked = self.molecule;
  asked.input.select = "";
  asked.input.frame = 1;
  return part_from(molecule, asked);
}

nb::dict parameters_of_path(const AskedPath& self) {
  const AskedModel& molecule = self.molecule;
  std::vector<NamedParameter> all = parameters_of(self);
  for (const auto& of_group : {option_parameters("input", input_fields(), molecule.input),
                               option_parameters("model", model_fields(), molecule.model)})
    all.insert(all.end(), of_group.begin(), of_group.end());
  return parameters_to_python(all);
}

nb::list rows_of_path() {
  nb::list rows = rows_for_commands(path_fields(), PathOptions());
  rows.extend(argument_rows(ModelArguments::path));
  return rows;
}

std::string argument_texts_of_path() {
  return argument_texts(path_fields(), PathOptions()) + ", " + argument_texts(ModelArguments::path);
}

std::string argument_docs_of_path() {
  return argument_docs(path_fields(), PathOptions()) + argument_docs(ModelArguments::path);
}

/// As `pliant.jobs.path.walk` finds and shows it.
nb::object path_between(const nb::object& start, const nb::object& end, const nb::object& output,
                        bool overwrite, const nb::kwargs& more) {
  nb::dict given(more);
  const AskedPath asked = asked_from(given);
  refuse_unknown(nb::module_::import_("pliant._core").attr("path"), nb::make_tuple(start, end),
                 given);
  return nb::module_::import_("pliant.jobs.path.walk")
      .attr("shown")(start, end, asked, output, overwrite);
}

constexpr const char* path_doc =
    R"(Moves a molecule towards another structure of itself, every frame whole.

Residues are matched by chain and number, else by sequence. What both structures have of contacts is
held.

Parameters
----------
start, end : Structure, path, Universe, AtomGroup, ...
    Molecules as ``sample`` takes them, of proteins or nucleic acids. `select`, `contacts` and
    `floppy_below` are about the start; all else holds for both.
)";

constexpr const char* rest_of_path_doc =
    R"(output : str or path, optional
    H5MD file to write frames to, or a PDB file with one model for each, when all are made; those that
    there are after Ctrl-C.
overwrite : bool
    Replace it.

Raises
------
OptionError
    An option out of range, or of which the model has no use.
InputError
    A file that cannot be read, or structures that do not match.
FileError
    The output exists or cannot be written.
)";

void bind_path_function(nb::module_& module) {
  const std::string any = any_molecule;
  const std::string signature = "def path(start: " + any + ", end: " + any + ", *, " +
                                argument_texts_of_path() +
                                ", output: str | os.PathLike[str] | None = None, "
                                "overwrite: bool = False) -> MolecularPath";
  const std::string doc = path_doc + argument_docs_of_path() + rest_of_path_doc;
  module.def("path", &path_between, "start"_a.none(), "end"_a.none(), nb::kw_only(),
             "output"_a = nb::none(), "overwrite"_a = false, "options"_a,
             nb::sig(signature.c_str()), doc.c_str());
}

}  // namespace

void bind_path_options(nb::module_& module) {
  const std::string doc = "What a path is asked for.\n\nParameters\n----------\n" +
                          argument_docs_of_path() +
                          "\nRaises\n------\nOptionError\n    One is out of range.\n";
  const std::string made = "def __init__(self, *, " + argument_texts_of_path() + ") -> None";
  const std::string part = "(self, molecule: " + std::string(any_molecule) + ") -> Structure";
  nb::class_<AskedPath> options(module, "PathOptions", doc.c_str());
  options.def("__init__", &make_options, "options"_a, nb::sig(made.c_str()))
      .def_prop_ro(
          "arrived_within",
          [](const AskedPath& self) { return find_path_atoms(self.atoms).arrived_within; },
          "r.m.s. distance at which the end is reached, Angstrom.")
      .def("start_of", &start_of, "molecule"_a.none(), nb::sig(("def start_of" + part).c_str()),
           "The part of a molecule that is to move.")
      .def("end_of", &end_of, "molecule"_a.none(), nb::sig(("def end_of" + part).c_str()),
           "The same of the end, of which `select` says nothing.")
      .def("parameters", &parameters_of_path,
           nb::sig("def parameters(self) -> dict[str, bool | int | float | str]"),
           "Every option by its path below /parameters of a recorded file: \"path/step\".");
  for (const auto& field : path_fields()) bind_value(options, field);
  module.def("path_rows", &rows_of_path, nb::sig("def path_rows() -> list[dict[str, typing.Any]]"),
             "The table of these options.");
  bind_path_function(module);
}

}  // namespace pliant::python
