// SPDX-License-Identifier: MIT
// The class Structure: columns of atoms as numpy arrays.
#include <algorithm>
#include <array>
#include <numeric>

#include "arrays.hpp"
#include "checks.hpp"
#include "messages.hpp"
#include "molecule/structure.hpp"
#include "molecule/structure_columns.hpp"
#include "pickling.hpp"
#include "pliant/base/elements.hpp"
#include "pliant/base/error.hpp"
#include "pliant/molecule/aromaticity.hpp"
#include "pliant/molecule/drawing.hpp"
#include "pliant/molecule/secondary_structure.hpp"
#include "pliant/molecule/structure/residue_order.hpp"
#include "texts.hpp"

namespace pliant::python {
namespace {

using TextArray = nb::typed<nb::object, nb::str>;

/// A column of the residues, one entry for each atom.
template <class TextOf>
nb::object residue_text_array(const Structure& self, TextOf text_of) {
  std::vector<nb::object> texts;  // one object a residue: the list of a protein stays small
  for (const Residue& residue : self.atoms.residues) texts.push_back(text_object(text_of(residue)));
  nb::list column;
  for (std::uint32_t residue : self.atoms.residue_of) column.append(texts[residue]);
  return text_array(column);
}

std::vector<std::int64_t> residue_ids_of(const Structure& self) {
  std::vector<std::int64_t> ids;
  for (std::uint32_t residue : self.atoms.residue_of)
    ids.push_back(self.atoms.residues[residue].number);
  return ids;
}

std::vector<std::int64_t> source_order_of(const Structure& self) {
  std::vector<std::int64_t> order(self.source_order.begin(), self.source_order.end());
  if (order.empty()) {
    order.resize(self.size());
    std::iota(order.begin(), order.end(), std::int64_t{0});
  }
  return order;
}

std::vector<double> masses_of(const Structure& self) {
  std::vector<double> masses;
  for (std::uint8_t element : self.atoms.elements) masses.push_back(element_mass(element));
  return masses;
}

std::vector<std::uint32_t> pairs_of(const std::vector<Bond>& bonds) {
  std::vector<std::uint32_t> pairs;
  pairs.reserve(2 * bonds.size());
  for (const Bond& bond : bonds) pairs.insert(pairs.end(), {bond.a, bond.b});
  return pairs;
}

std::vector<std::uint8_t> orders_of(const std::vector<Bond>& bonds) {
  std::vector<std::uint8_t> orders;
  for (const Bond& bond : bonds) orders.push_back(bond.order);
  return orders;
}

void set_positions(Structure& self, const ArrayLike& values) {
  const std::vector<Vec3> from = positions_from(values, self.size());
  std::copy(from.begin(), from.end(), self.positions.begin());  // in place: views stay views
}

std::string structure_repr(const Structure& self) {
  std::string text = "<pliant.Structure";
  if (!self.source.empty()) text.append(" ").append(pliant::quoted(self.source));
  return text + ": " + std::to_string(self.size()) + " atoms, " +
         std::to_string(self.bonds.size()) + " bonds>";
}

std::string label_of(const Structure& self, std::int64_t atom) {
  if (atom < 0 || static_cast<std::uint64_t>(atom) >= self.size())
    fail_index("atom", atom, self.size());
  return self.atoms.label(static_cast<std::size_t>(atom));
}

void bind_order(nb::class_<Structure>& structure) {
  structure.def_prop_ro(
      "source_order", [](const Structure& self) { return array_of(source_order_of(self)); },
      nb::rv_policy::reference,
      "(N,) int64: where each atom stands in the file or object that the structure was read or "
      "made from, counted among those that it has. It has another order where atoms of one residue "
      "stand apart there.");
  structure.def(
      "gather_residues", [](Structure& self) { gather_residues(self, python_log()); },
      "Puts the atoms of each residue together: those that agree in chain, residue number, "
      "insertion code and residue name, unless names of heavy atoms repeat. ``source_order`` then "
      "tells where they stood.");
}

void bind_atoms(nb::class_<Structure>& structure) {
  def_text(
      structure, "names",
      [](const Structure& self) {
        return text_array(self.size(), [&](std::size_t i) { return self.atoms.names[i]; });
      },
      "(N,) atom names.");
  def_text(
      structure, "symbols",
      [](const Structure& self) {
        return text_array(self.size(),
                          [&](std::size_t i) { return element_symbol(self.atoms.elements[i]); });
      },
      "(N,) symbols of the elements; \"X\" where the element is not known.");
  structure.def_prop_ro(
      "elements",
      [](nb::handle_t<Structure> self) {
        return const_view_of(
            std::span<const std::uint8_t>(nb::cast<const Structure&>(self).atoms.elements), self);
      },
      "(N,) uint8, read-only view: atomic numbers; 0 where the element is not known.");
  structure.def_prop_ro(
      "serials",
      [](nb::handle_t<Structure> self) {
        return const_view_of(
            std::span<const std::int64_t>(nb::cast<const Structure&>(self).atoms.serials), self);
      },
      "(N,) int64, read-only view: the number of each atom in the file.");
  structure.def_prop_ro(
      "b_factors",
      [](nb::handle_t<Structure> self) {
        return const_view_of(std::span<const float>(nb::cast<const Structure&>(self).b_factors),
                             self);
      },
      "(N,) float32, read-only view: B factors of the file (Angstrom^2), or what stands in their "
      "column, such as pLDDT; (0,) where the format has none.");
  structure.def_prop_ro(
      "charges",
      [](const Structure& self) {
        return array_of(std::vector<std::int64_t>(self.charges.begin(), self.charges.end()));
      },
      nb::rv_policy::reference, "(N,) int64: formal charges; (0,) where none are known.");
  structure.def_prop_ro(
      "masses", [](const Structure& self) { return array_of(masses_of(self)); },
      nb::rv_policy::reference, "(N,) float64: masses of the elements in u.");
}

void bind_residues(nb::class_<Structure>& structure) {
  structure.def_prop_ro(
      "residue_of",
      [](nb::handle_t<Structure> self) {
        return const_view_of(
            std::span<const std::uint32_t>(nb::cast<const Structure&>(self).atoms.residue_of),
            self);
      },
      "(N,) uint32, read-only view: the residue of each atom, from 0.");
  structure.def_prop_ro(
      "residue_count", [](const Structure& self) { return self.atoms.residues.size(); },
      "Number of residues.");
  structure.def_prop_ro(
      "residue_ids", [](const Structure& self) { return array_of(residue_ids_of(self)); },
      nb::rv_policy::reference, "(N,) int64: the number of each atom's residue.");
  structure.def(
      "secondary_structure",
      [](const Structure& self) { return secondary_structure(self.atoms, self.positions); },
      "One letter a residue, by the hydrogen bonds of the backbone (DSSP, with hydrogens where "
      "they "
      "would be):\n\"H\" helix, \"E\" strand or bridge, \"-\" neither, \" \" a residue without N, "
      "CA, "
      "C and O.");
  def_text(
      structure, "residue_names",
      [](const Structure& self) {
        return residue_text_array(self, [](const Residue& r) { return std::string_view(r.name); });
      },
      "(N,) the name of each atom's residue.");
  def_text(
      structure, "insertion_codes",
      [](const Structure& self) {
        return residue_text_array(
            self, [](const Residue& r) { return insertion_text(r.insertion_code); });
      },
      "(N,) the insertion code of each atom's residue; \"\" for none.");
  def_text(
      structure, "chains",
      [](const Structure& self) {
        return residue_text_array(self, [](const Residue& r) { return std::string_view(r.chain); });
      },
      "(N,) the chain of each atom's residue; \"\" for none.");
}

void bind_bonds(nb::class_<Structure>& structure) {
  structure.def_prop_ro(
      "bonds", [](const Structure& self) { return pairs_array_of(pairs_of(self.bonds)); },
      nb::rv_policy::reference, "(M, 2) uint32: bonded atoms, sorted; a copy.");
  structure.def_prop_ro(
      "bond_orders", [](const Structure& self) { return array_of(orders_of(self.bonds)); },
      nb::rv_policy::reference,
      "(M,) uint8: 1, 2, 3; 4 for aromatic; 0 where the order is not known.");
  structure.def_prop_ro(
      "aromatic_bonds", [](const Structure& self) { return mask_of(find_aromatic_bonds(self)); },
      nb::rv_policy::reference,
      "(M,) bool: whether each bond is of an aromatic ring, as counted from the pi electrons of "
      "rings of\n5 to 7 atoms: the same for all Kekule forms. False where orders are not known.");
  def_text(
      structure, "bond_origins",
      [](const Structure& self) {
        return text_array(self.bonds.size(), [&](std::size_t k) {
          return bond_origin_names[static_cast<std::size_t>(self.bonds[k].origin)];
        });
      },
      "(M,) origin of each bond: \"file\", \"residue\", \"link\" or \"distance\".");
}

nb::object cell_to_python(const Structure& self) {
  if (!self.cell) return nb::none();
  return nb::cast(new_positions({self.cell->edges.begin(), self.cell->edges.end()}),
                  nb::rv_policy::move);
}

void set_cell(Structure& self, const ArrayLike& edges) {
  self.cell.reset();
  if (edges.object.is_none()) return;
  const std::vector<Vec3> from = positions_from(edges, "cell");
  if (from.size() != 3)
    throw InputError("cell: expected shape (3, 3), found (" + std::to_string(from.size()) + ", 3)");
  self.cell = cell_of(std::array<Vec3, 3>{from[0], from[1], from[2]});
}

void bind_cell(nb::class_<Structure>& structure) {
  structure.def_prop_rw(
      "cell", &cell_to_python, &set_cell,
      nb::for_getter(nb::sig("def cell(self) -> numpy.typing.NDArray[numpy.float64] | None")),
      nb::for_setter(nb::sig("def cell(self, edges: numpy.typing.ArrayLike | None, /) -> None")),
      nb::arg().none(),
      "(3, 3) float64, a copy: the edges of the periodic cell (Angstrom); None: none is known.");
}

void bind_facts(nb::class_<Structure>& structure) {
  bind_cell(structure);
  structure
      .def_prop_rw(
          "positions",
          [](nb::handle_t<Structure> self) {
            return view_of(nb::cast<Structure&>(self).positions, self);
          },
          &set_positions, "(N, 3) float64 view, Angstrom. Assigning copies into the same memory.")
      .def_prop_ro(
          "title", [](const Structure& self) { return text_object(self.title); },
          nb::sig("def title(self) -> str"), "Title in the file.")
      .def_prop_ro(
          "source", [](const Structure& self) { return text_object(self.source); },
          nb::sig("def source(self) -> str"), "Name of the file it was read from.")
      .def_prop_ro(
          "assemblies", [](const Structure& self) { return self.assemblies; },
          "Names of the biological assemblies that the file states; see ``read``.")
      .def_ro("format", &Structure::format, "Name of the file's format.")
      .def_prop_ro("is_drawing", &is_drawing,
                   "Whether it is a 2-D drawing rather than a flat molecule such as benzene.")
      .def_ro("model", &Structure::model, "Number of the model or frame, from 1.")
      .def_ro("model_count", &Structure::model_count, "Number of models or frames in the file.")
      .def("label", &label_of, "atom"_a, "Name of an atom in messages: \"A:LYS12:CA\".")
      .def("__len__", &Structure::size)
      .def("__repr__", &structure_repr);
}

constexpr const char* structure_doc =
    R"(Atoms with names, elements, residues and positions, and their bonds.

Made by ``read``, by the adapters, or from columns:

Parameters
----------
positions : (N, 3) Angstrom
elements : (N,) atomic numbers or symbols, optional
    0 or "" where it is not known, which is the default.
names : N strings, optional
    Default: the symbols.
residue_names, residue_ids, insertion_codes, chains : N each, optional
    Default: "UNK", 1, "", "". Consecutive atoms that agree in all of them make a residue.
serials : (N,) integers, optional
    Default: 1 to N.
bonds : (M, 2) integers, optional
    Pairs of atoms, from 0.
bond_orders : (M,) integers, optional
    1, 2, 3; 4 for aromatic; 0 not known.
charges : (N,) integers, optional
    Formal charges, -127 to 127; default: none are known.
title : str

Raises
------
InputError
    Lengths that differ, an unknown element, a bond to an unknown atom or of an atom to itself,
    a position that is not finite.
)";

}  // namespace

nb::object structure_from(nb::handle argument) {
  if (nb::isinstance<Structure>(argument)) return nb::borrow(argument);
  return nb::module_::import_("pliant.trajectory.sources").attr("structure_of")(argument);
}

nb::class_<Structure> bind_structure(nb::module_& module) {
  nb::class_<Structure> structure(module, "Structure", structure_doc);
  structure.def("__init__", &make_structure, "positions"_a, nb::kw_only(),
                "elements"_a = nb::none(), "names"_a = nb::none(), "residue_names"_a = nb::none(),
                "residue_ids"_a = nb::none(), "insertion_codes"_a = nb::none(),
                "chains"_a = nb::none(), "serials"_a = nb::none(), "bonds"_a = nb::none(),
                "bond_orders"_a = nb::none(), "charges"_a = nb::none(), "title"_a = "");
  bind_facts(structure);
  bind_atoms(structure);
  bind_order(structure);
  bind_residues(structure);
  bind_bonds(structure);
  bind_pickling(structure);
  return structure;
}

}  // namespace pliant::python
