// SPDX-License-Identifier: MIT
// Rigid clusters and degrees of freedom of molecules, by counting.
#include <algorithm>
#include <limits>

#include "arrays.hpp"
#include "framework/framework_rigidity.hpp"
#include "messages.hpp"
#include "model/model_arguments.hpp"
#include "model/molecular_contacts.hpp"
#include "molecule/structure.hpp"
#include "option_fields.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/jobs/rigidity_task.hpp"
#include "pliant/model/contacts/contact_file.hpp"
#include "pliant/model/rigidity/rigidity_dilution.hpp"

namespace pliant::python {
namespace {

/// Integers of any type as an array of int64.
template <class Values>
Array1<std::int64_t> integers_of(const Values& values) {
  return array_of(std::vector<std::int64_t>(values.begin(), values.end()));
}

/// One value of each edge, as `value(k)` gives it.
template <class Value>
auto of_edges(const MoleculeRigidity& self, const Value& value) {
  std::vector<decltype(value(std::size_t{0}))> values;
  for (std::size_t k = 0; k < self.rigidity.network.edges.size(); ++k) values.push_back(value(k));
  return values;
}

ContactModel contact_model_from(const nb::handle& argument, AskedModel asked) {
  if (nb::isinstance<MolecularModel>(argument)) {
    const auto& model = nb::cast<const MolecularModel&>(argument);
    refuse_for_built_model(asked, "contacts");
    std::optional<std::vector<MolecularContact>> contacts = std::move(asked.contacts);
    if (!asked.model.contacts.empty())
      contacts = read_contacts(path_of(asked.model.contacts), model.structure);
    return {model.structure, contacts ? *contacts : model.contacts, model.notes, model.missing,
            model.left_out};
  }
  const nb::object part = part_from(argument, asked);
  const auto& structure = nb::cast<const Structure&>(part);
  const ModelOptions options = options_of(std::move(asked), ModelKind::protein);
  const nb::gil_scoped_release no_gil;
  return contact_model(structure, options);
}

MoleculeRigidity rigidity_of(const nb::handle& structure, const nb::kwargs& more) {
  if (is_graph(structure)) throw nb::next_overload();
  nb::dict given(more);
  RigidityAsked counting;
  take_values(rigidity_fields(), given, counting);
  AskedModel asked = take_arguments(ModelArguments::contacts, given);
  refuse_unknown(nb::module_::import_("pliant._core").attr("rigidity"), nb::make_tuple(structure),
                 given);
  ContactModel model = contact_model_from(structure, std::move(asked));
  const nb::gil_scoped_release no_gil;
  return find_rigidity(std::move(model), counting);
}

/// The columns of the rows, and which cluster each residue is in at each row.
struct DilutionColumns {
  std::vector<double> cutoff;
  std::vector<std::int64_t> hydrogen_bonds, freedoms, redundant, clusters, largest, of_residue;
};

DilutionColumns dilution_columns(const MoleculeRigidity& self) {
  DilutionColumns columns;
  const RigidityNetwork& network = self.rigidity.network;
  const auto& residue_of = self.model.structure.atoms.residue_of;
  const std::size_t residues = self.model.structure.atoms.residues.size();
  dilute_hydrogen_bonds(network, [&](const DilutionRow& row, const ClusterList& clusters) {
    const std::size_t last = network.first_hydrogen_bond + row.hydrogen_bonds - 1;
    columns.cutoff.push_back(row.hydrogen_bonds == 0
                                 ? -std::numeric_limits<double>::infinity()
                                 : self.model.contacts[network.contact_of(last)].energy);
    columns.hydrogen_bonds.push_back(static_cast<std::int64_t>(row.hydrogen_bonds));
    columns.freedoms.push_back(static_cast<std::int64_t>(row.freedoms));
    columns.redundant.push_back(static_cast<std::int64_t>(row.redundant));
    columns.clusters.push_back(static_cast<std::int64_t>(row.clusters));
    columns.largest.push_back(row.largest[0]);
    std::vector<std::int64_t> of_residue(residues, std::numeric_limits<std::int64_t>::max());
    for (std::size_t atom = 0; atom < residue_of.size(); ++atom) {
      std::int64_t& cluster = of_residue[residue_of[atom]];
      cluster = std::min<std::int64_t>(cluster, clusters.of_body[atom]);
    }
    columns.of_residue.insert(columns.of_residue.end(), of_residue.begin(), of_residue.end());
  });
  return columns;
}

nb::dict dilution_of(const MoleculeRigidity& self) {
  DilutionColumns columns;
  {
    const nb::gil_scoped_release no_gil;
    columns = dilution_columns(self);
  }
  const std::size_t rows = columns.cutoff.size();
  nb::dict found;
  // Rows came from no hydrogen bond to all.
  const auto put = [&](const char* name, nb::object values) {
    found[name] = values[nb::slice(nb::none(), nb::none(), nb::int_(-1))].attr("copy")();
  };
  put("cutoff", nb::cast(array_of(std::move(columns.cutoff))));
  put("hydrogen_bonds", nb::cast(array_of(std::move(columns.hydrogen_bonds))));
  put("degrees_of_freedom", nb::cast(array_of(std::move(columns.freedoms))));
  put("redundant", nb::cast(array_of(std::move(columns.redundant))));
  put("clusters", nb::cast(array_of(std::move(columns.clusters))));
  put("largest", nb::cast(array_of(std::move(columns.largest))));
  const nb::object flat = nb::cast(array_of(std::move(columns.of_residue)));
  put("residue_cluster", flat.attr("reshape")(rows, self.model.structure.atoms.residues.size()));
  return found;
}

constexpr const char* rigidity_doc =
    R"(Counts degrees of freedom: which atoms of a molecule move as one, and which bonds turn.

Body-bar pebble game, as FIRST plays it (Jacobs, Rader, Kuhn, Thorpe, Proteins 44 (2001) 150): each
atom is a body with six freedoms; a bond that may turn takes five of them, one that does not six, a
contact as many as its kind has ``bars`` (``contact_kinds()``). What is left are degrees of freedom.
Only the graph counts, not positions, and contacts hold as if they never broke: the result depends on
the cut-off of hydrogen bonds (``Rigidity.dilution``).

Parameters
----------
structure : Structure, path, Universe, AtomGroup, rdkit.Chem.Mol or MolecularModel
    A molecule, as ``sample`` takes it, which is prepared first; or a model, which is taken with its
    contacts as it is. Of a Graph, a Framework or the path of a graph XML file (.xml) the freedoms of
    joints and bars are found: a FrameworkRigidity, which takes no options.
)";

constexpr const char* refusals_doc =
    R"(
Raises
------
InputError, OptionError
    As ``prepare`` does; a contact that names no atom; bars out of range; an atom of
    `free_angles` none of whose neighbours has held angles.
)";

constexpr const char* dilution_doc =
    R"(Takes hydrogen bonds out one by one, the weakest first.

Returns
-------
dict of arrays, L = hydrogen bonds + 1 rows from all to none
    cutoff (L,) energy of the weakest one left (kcal/mol; -inf where none is); hydrogen_bonds (L,)
    left; degrees_of_freedom (L,); redundant (L,) bars; clusters (L,) of three atoms or more; largest
    (L,) atoms; residue_cluster (L, R) the largest cluster with an atom of each residue, 0 the
    largest.
)";

constexpr const char* picture_doc =
    R"(The dilution plot as an SVG picture: which residues are rigid together as hydrogen bonds go.

One line each time that clusters of residues change; bars of one colour in a line are one cluster
(Hespenheide, Rader, Thorpe, Kuhn, J. Mol. Graph. Model. 21 (2002) 195).

Parameters
----------
name : str
    Name of the molecule in the title; "": that of its file.
)";

constexpr const char* page_doc =
    R"(Writes an HTML page: the molecule in 3-D coloured by cluster and by flexibility, the clusters.

The page is one file that opens in a browser without a network. Ribbons of a protein need
MDAnalysis (``pip install "pliant[analysis]"``).

Parameters
----------
path : path
    The file to write.
dilution : bool
    Whether the dilution plot is in it.
overwrite : bool
    Whether a file of that name is replaced.

Raises
------
FileError
    It exists or cannot be written.
)";

std::string picture_of(const MoleculeRigidity& self, const std::string& name) {
  return draw_dilution(self, name).svg;
}

void write_page(const nb::object& self, const nb::object& path, bool dilution, bool overwrite) {
  nb::module_::import_("pliant.report.rigidity.rigidity_page")
      .attr("write_rigidity_page")(self, path, "dilution"_a = dilution, "overwrite"_a = overwrite);
}

using Self = const MoleculeRigidity&;

void bind_totals(nb::class_<MoleculeRigidity>& bound) {
  bound
      .def_prop_ro(
          "structure", [](Self self) { return self.model.structure; },
          "The structure whose atoms were counted, after preparation.")
      .def_prop_ro(
          "contacts", [](Self self) { return contacts_to_python(self.model.contacts); },
          nb::sig("def contacts(self) -> numpy.typing.NDArray[numpy.void]"),
          "(K,) what holds it besides bonds, as ``contacts`` gives it.")
      .def_prop_ro(
          "degrees_of_freedom", [](Self self) { return self.rigidity.found.freedoms; },
          "Internal ones: 6 atoms - independent bars - 6 parts.")
      .def_prop_ro(
          "parts", [](Self self) { return self.rigidity.found.components; },
          "Parts of the molecule that nothing links; each moves as a whole besides.")
      .def_prop_ro(
          "bars", [](Self self) { return self.rigidity.found.bars; }, "All of them.")
      .def_prop_ro(
          "redundant",
          [](Self self) { return self.rigidity.found.bars - self.rigidity.found.rank; },
          "Bars that depend on others.")
      .def_prop_ro(
          "hinges", [](Self self) { return self.rigidity.hinges; },
          "Bonds that may turn: those with five bars.")
      .def_prop_ro(
          "flexible_bonds", [](Self self) { return self.rigidity.flexible_bonds; },
          "Of these, those between different clusters.")
      .def("dilution_picture", &picture_of, "name"_a = "", nb::call_guard<nb::gil_scoped_release>(),
           picture_doc)
      .def("write_page", &write_page, "path"_a, nb::kw_only(), "dilution"_a = false,
           "overwrite"_a = false,
           nb::sig("def write_page(self, path: str | os.PathLike, *, dilution: bool = False, "
                   "overwrite: bool = False) -> None"),
           page_doc)
      .def("dilution", &dilution_of,
           nb::sig("def dilution(self) -> dict[str, numpy.typing.NDArray[typing.Any]]"),
           dilution_doc);
}

void bind_counts(nb::class_<MoleculeRigidity>& bound) {
  bound
      .def_prop_ro(
          "rigid_clusters", [](Self self) { return self.rigidity.found.clusters.count(); },
          "Clusters of three atoms or more.")
      .def_prop_ro(
          "coloured_clusters",
          [](Self self) {
            return coloured_clusters(self.model.structure, self.rigidity.found.clusters);
          },
          "Number of clusters, the largest first, with a colour: in proteins those of 20 atoms or "
          "more.")
      .def_prop_ro(
          "rings_of_six", [](Self self) { return self.rigidity.rings_of_six; },
          "Rings of six bonds that may turn: counted as rigid, though a boat moves.")
      .def_prop_ro(
          "small_pieces", [](Self self) { return self.rigidity.found.clusters.small_pieces(); },
          "Atoms, and bonds of two atoms, that are in no cluster.");
}

void bind_columns(nb::class_<MoleculeRigidity>& bound) {
  bound
      .def_prop_ro(
          "cluster", [](Self self) { return integers_of(self.rigidity.found.clusters.of_body); },
          nb::rv_policy::reference,
          "(N,) int64: the rigid cluster of each atom, 0 the largest; rigid_clusters and more: a "
          "small piece.")
      .def_prop_ro(
          "cluster_sizes",
          [](Self self) { return integers_of(self.rigidity.found.clusters.sizes); },
          nb::rv_policy::reference,
          "(C,) int64: atoms of each cluster and small piece, descending.")
      .def_prop_ro(
          "residue_flexibility",
          [](Self self) {
            std::vector<double> values;
            for (const auto& residue : self.rigidity.residues) values.push_back(residue.index);
            return array_of(std::move(values));
          },
          nb::rv_policy::reference,
          "(R,) float64: mean flexibility of N-CA and CA-C, else of all bonds in the "
          "residue that may turn; 0 where there is none.")
      .def_prop_ro(
          "residue_cluster",
          [](Self self) {
            std::vector<std::int64_t> values;
            for (const auto& residue : self.rigidity.residues) values.push_back(residue.cluster);
            return array_of(std::move(values));
          },
          nb::rv_policy::reference,
          "(R,) int64: the largest cluster that has an atom of each residue.");
}

void bind_edges(nb::class_<MoleculeRigidity>& bound) {
  bound
      .def_prop_ro(
          "edges",
          [](Self self) {
            std::vector<std::int64_t> ends;
            for (const BodyEdge& edge : self.rigidity.network.edges)
              ends.insert(ends.end(), {edge.a, edge.b});
            return pairs_array_of(std::move(ends));
          },
          nb::rv_policy::reference,
          "(E, 2) int64: atoms of bonds, then of contacts without a hydrogen, then of "
          "hydrogen bonds (H and acceptor) from the strongest on.")
      .def_prop_ro(
          "edge_bars",
          [](Self self) {
            return integers_of(
                of_edges(self, [&](std::size_t k) { return self.rigidity.network.edges[k].bars; }));
          },
          nb::rv_policy::reference, "(E,) int64: bars of each edge.")
      .def_prop_ro(
          "edge_redundant", [](Self self) { return integers_of(self.rigidity.found.redundant); },
          nb::rv_policy::reference, "(E,) int64: bars that depend on those of the edges before.")
      .def_prop_ro(
          "edge_flexibility", [](Self self) { return array_of(self.rigidity.flexibility); },
          nb::rv_policy::reference,
          "(E,) float64: 1 turns freely, 1/7 in a ring of seven, 0 locked, below 0 locked "
          "with redundant bars.")
      .def_prop_ro(
          "edge_contact",
          [](Self self) {
            const RigidityNetwork& network = self.rigidity.network;
            return array_of(of_edges(self, [&](std::size_t k) {
              return network.is_bond(k) ? std::int64_t{-1} : std::int64_t{network.contact_of(k)};
            }));
          },
          nb::rv_policy::reference,
          "(E,) int64: the row of ``contacts`` of each edge; -1: a bond.");
}

}  // namespace

void bind_rigidity(nb::module_& module) {
  nb::class_<MoleculeRigidity> bound(module, "Rigidity", "Rigid and flexible parts of a molecule.");
  bind_totals(bound);
  bind_counts(bound);
  bind_columns(bound);
  bind_edges(bound);
  bound.def("__repr__", [](Self self) {
    return "<pliant.Rigidity: " + std::to_string(self.rigidity.found.freedoms) +
           " degrees of freedom of " + std::to_string(self.rigidity.network.atoms) + " atoms>";
  });
  const std::string signature =
      "def rigidity(structure: MolecularModel | " + std::string(any_molecule) + ", *, " +
      argument_texts(ModelArguments::contacts) + ", " +
      argument_texts(rigidity_fields(), RigidityAsked()) + ") -> Rigidity";
  const std::string doc = rigidity_doc + argument_docs(ModelArguments::contacts) +
                          argument_docs(rigidity_fields(), RigidityAsked()) + refusals_doc;
  module.def("rigidity", &rigidity_of, "structure"_a.none(), "options"_a,
             nb::sig(signature.c_str()), doc.c_str());
  bind_framework_rigidity(module);
}

}  // namespace pliant::python
