// SPDX-License-Identifier: MIT
// Structures: reading files, bond perception, frameworks of molecules.
#include <nanobind/stl/filesystem.h>

#include "arrays.hpp"
#include "messages.hpp"
#include "molecule/structure.hpp"
#include "pliant/base/choices.hpp"
#include "pliant/base/elements.hpp"
#include "pliant/base/error.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/model/prepare/select_part.hpp"
#include "pliant/molecule/bars_file.hpp"
#include "pliant/molecule/bonds/bonds.hpp"
#include "pliant/molecule/build_framework.hpp"
#include "pliant/molecule/read/read.hpp"
#include "refusals.hpp"
#include "tables.hpp"

namespace pliant::python {
namespace {

void perceive(Structure& structure, double slack, double shortest, bool guess_distances) {
  const BondOptions options{slack, shortest, guess_distances, python_log()};
  const nb::gil_scoped_release no_gil;
  perceive_bonds(structure, options);
}

bool whole(Structure& structure) {
  const Log log = python_log();
  const nb::gil_scoped_release no_gil;
  return make_whole(structure, log);
}

Structure select(const Structure& structure, std::string_view selection) {
  const Log log = python_log();
  const nb::gil_scoped_release no_gil;
  return select_part(structure, selection, log);
}

/// Most names are numbers.
std::string assembly_from(const nb::handle& assembly) {
  if (assembly.is_none()) return {};
  if (nb::isinstance<nb::bool_>(assembly) ||
      (!nb::isinstance<nb::int_>(assembly) && !nb::isinstance<nb::str>(assembly)))
    refuse_argument("assembly", assembly, "int | str | None", nb::none(), nb::none());
  return nb::cast<std::string>(nb::str(assembly));
}

ReadOptions read_options(std::int64_t model, const std::optional<std::string>& format,
                         const nb::handle& assembly) {
  if (model < 0) throw OptionError("model is " + std::to_string(model) + ": must be from 1");
  ReadOptions options;
  options.model = static_cast<std::size_t>(model);
  options.format = format.value_or("");
  options.assembly = assembly_from(assembly);
  options.log = python_log();
  return options;
}

/// What is read, a file or text, with its bonds. Needs the GIL not to be held.
template <class Source>
Structure read_from(const Source& source, const ReadOptions& options, bool perceive_bonds,
                    bool distance_bonds) {
  Structure structure = read_structure(source, options);
  BondOptions bonding;
  bonding.guess_distances = distance_bonds;
  bonding.log = options.log;
  if (perceive_bonds) pliant::perceive_bonds(structure, bonding);
  return structure;
}

Structure read(const std::filesystem::path& path, std::int64_t model,
               const std::optional<std::string>& format, bool perceive_bonds, bool distance_bonds,
               std::uint64_t max_input, const nb::object& assembly) {
  ReadOptions options = read_options(model, format, assembly);
  options.max_input = max_input;
  const nb::gil_scoped_release no_gil;
  return read_from(path, options, perceive_bonds, distance_bonds);
}

Structure read_text(std::string_view text, std::string_view name, std::int64_t model,
                    const std::optional<std::string>& format, bool perceive_bonds,
                    bool distance_bonds, const nb::object& assembly) {
  const ReadOptions options = read_options(model, format, assembly);
  const nb::gil_scoped_release no_gil;
  return read_from(SourceText{name, text}, options, perceive_bonds, distance_bonds);
}

Framework framework_of(const Structure& structure, const std::filesystem::path& bars,
                       const std::string& pin, bool use_masses) {
  BuildOptions options;
  options.pin = pin;
  options.use_masses = use_masses;
  const nb::gil_scoped_release no_gil;
  take_bars(path_text(bars), structure, options);
  return build_framework(structure, options);
}

constexpr const char* framework_doc = R"(The framework whose joints are the atoms.

Parameters
----------
bars : str or path
    ``bonds``: a bar for each bond; ``angles``: and for each pair of atoms bonded to one atom, and
    across the torsions of planar groups;
    ``none``; else the path of a bars file, which states bars, limits and sterics.
pin : str
    Selection of atoms that never move, in the words of MDAnalysis: ``"resid 3-8 and name CA"``.
use_masses : bool
    Give joints the masses of their atoms.

Raises
------
InputError
    A bar would have no length; the bars file is wrong, with its line.
FileError
    The bars file cannot be read.
OptionError
    An unknown choice, or a selection that cannot be understood.
)";

constexpr const char* select_doc =
    R"(Returns the selected atoms as a structure of their own.

Parameters
----------
selection : str
    In the words of MDAnalysis: ``"protein"``, ``"not resname HOH"``.

Raises
------
OptionError
    The selection cannot be understood, or names no atom.

Warns
-----
PliantWarning
    Bonds to atoms that are left out vanish.
)";

constexpr const char* read_doc =
    R"(Reads one model of a molecule file: PDB, mmCIF, XYZ, SDF, also compressed (gz, bz2, xz).

Parameters
----------
path : str or path
model : int
    Which model, frame or record, from 1.
format : str, optional
    A name in ``formats()``; default: by extension, then by content.
perceive_bonds : bool
    Add bonds that the file does not state: residue templates, links, distances.
distance_bonds : bool
    Guess the bonds that are lacking then from distances.
max_input : int
    Bytes that the file may have, and expand to, at most 2^32. What is larger is refused.
assembly : int or str, optional
    Name of a biological assembly that the file states (``Structure.assemblies``), to be made: PDB
    (REMARK 350) and mmCIF. Copies of a chain get different names.

Raises
------
InputError
    Names file, line and field, what was expected and what was found.
FileError
    The file cannot be read.
OptionError
    No such format, model or assembly.

Warns
-----
PliantWarning
    Once for each kind of guess. Notes that are no warnings go to the logger ``pliant``.
)";

void bind_formats(nb::module_& module) {
  bind_row<Format>(module, "Format", "One row of the table of formats.")
      .def_prop_ro(
          "extensions",
          [](const Format& self) {
            return std::vector<std::string>(self.extensions.begin(), self.extensions.end());
          },
          "File name extensions: \".pdb\".");
  module.def(
      "formats", [] { return rows_of(formats()); }, nb::rv_policy::reference,
      "The table of formats that ``read`` knows.");
}

}  // namespace

void bind_molecule(nb::module_& module) {
  const BondOptions bonding;
  bind_formats(module);
  bind_structure(module)
      .def("perceive_bonds", &perceive, nb::kw_only(), "slack"_a = bonding.slack,
           "shortest"_a = bonding.shortest, "guess_distances"_a = bonding.guess_distances,
           "Adds the bonds found by residue templates, links and distances; existing bonds are "
           "kept.\n\nslack: Angstrom added to the sum of two covalent radii (Cordero et al.,\n"
           "Dalton Trans. 2008, 2832); shortest: closer atoms are not bonded.\n\nMolecules that "
           "the periodic cell cuts are made whole, as ``make_whole`` does.")
      .def("make_whole", &whole,
           "Moves atoms by edges of ``cell`` until molecules that it cuts are whole, along their "
           "bonds.\n\nThe larger part of each stays, as do positions where no bond is cut. True if "
           "any was moved.")
      .def("select", &select, "selection"_a, select_doc)
      .def("framework", &framework_of, "bars"_a = "bonds", "pin"_a = "", nb::kw_only(),
           "use_masses"_a = true, framework_doc);
  module.def(
      "read", &read, "path"_a, "model"_a = 1, "format"_a = nb::none(), nb::kw_only(),
      "perceive_bonds"_a = true, "distance_bonds"_a = true,
      "max_input"_a = std::uint64_t{usual_text}, "assembly"_a = nb::none(),
      nb::sig("def read(path: str | os.PathLike, model: int = 1, format: str | None = None, "
              "*, perceive_bonds: bool = True, distance_bonds: bool = True, "
              "max_input: int = 2000000000, assembly: int | str | None = None) -> Structure"),
      read_doc);
  module.def(
      "read_text", &read_text, "text"_a, "name"_a = "text", "model"_a = 1, "format"_a = nb::none(),
      nb::kw_only(), "perceive_bonds"_a = true, "distance_bonds"_a = true,
      "assembly"_a = nb::none(),
      nb::sig("def read_text(text: str, name: str = \"text\", model: int = 1, "
              "format: str | None = None, *, perceive_bonds: bool = True, "
              "distance_bonds: bool = True, assembly: int | str | None = None) -> Structure"),
      "Reads text in memory as ``read`` does; ``name`` is for messages and gives the extension.");
}

}  // namespace pliant::python
