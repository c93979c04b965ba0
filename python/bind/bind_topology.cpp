// SPDX-License-Identifier: MIT
// Text files beside trajectories: PDB topologies, and graph XML.
#include <nanobind/stl/filesystem.h>

#include "arrays.hpp"
#include "checks.hpp"
#include "messages.hpp"
#include "pliant/molecule/structure/structure.hpp"
#include "pliant/record/topology_pdb.hpp"
#include "pliant/record/xml/graph_xml.hpp"
#include "pliant/record/xml/write_graph_xml.hpp"
#include "recorded_bonds.hpp"

namespace pliant::python {

void bind_topology(nb::module_& module);

namespace {

void write_pdb(const std::filesystem::path& path, const Structure& structure,
               const OptionalArray& positions, bool overwrite, bool hybrid36_bonds) {
  const std::vector<Vec3> points =
      positions ? positions_from(*positions, structure.size()) : structure.positions;
  const TopologyPdbOptions options{overwrite, hybrid36_bonds, structure.title, python_log()};
  const nb::gil_scoped_release no_gil;
  write_topology_pdb(path, structure.atoms, points, recorded_bonds(structure), options);
}

GraphFile read_graph(const std::filesystem::path& path) {
  const Log log = python_log();
  const nb::gil_scoped_release no_gil;
  return read_graph_xml(path, log);
}

GraphFile make_graph(Framework framework, const ArrayLike& positions,
                     const std::vector<std::vector<std::int64_t>>& cycles) {
  GraphFile graph{std::move(framework), {}, {}};
  graph.positions = positions_from(positions, graph.framework.joint_count());
  for (const std::vector<std::int64_t>& cycle : cycles) {
    graph.cycles.emplace_back();
    for (std::int64_t joint : cycle)
      graph.cycles.back().push_back(joint_at(graph.framework, joint));
  }
  return graph;
}

void bind_graph(nb::module_& module) {
  nb::class_<GraphFile>(
      module, "Graph",
      "A framework with its positions, as a graph XML file holds it.\n\n"
      "``positions`` is (N, 3) in Angstrom, ``cycles`` lists joints along cycles.")
      .def(
          "__init__",
          [](GraphFile* self, const Framework& framework, const ArrayLike& positions,
             const std::vector<std::vector<std::int64_t>>& cycles) {
            new (self) GraphFile(make_graph(framework, positions, cycles));
          },
          "framework"_a, "positions"_a, "cycles"_a = std::vector<std::vector<std::int64_t>>{})
      .def_ro("framework", &GraphFile::framework, "Its joints are called by the ids in the file.")
      .def_prop_ro(
          "positions",
          [](nb::handle_t<GraphFile> self) {
            return view_of(nb::cast<GraphFile&>(self).positions, self);
          },
          "(N, 3) float64 view, Angstrom.")
      .def_ro("cycles", &GraphFile::cycles, "Each as the joints along it.")
      .def(
          "text",
          [](const GraphFile& self) {
            return write_graph_xml(self.framework, self.positions, self.cycles);
          },
          "The file's text, which reads back to the same bits.");
  module.def("read_graph_xml", &read_graph, "path"_a,
             "Reads a graph XML file: a framework with its positions.\n\n"
             "Raises InputError naming file, line and attribute.");
}

}  // namespace

void bind_topology(nb::module_& module) {
  module.def(
      "write_topology_pdb", &write_pdb, "path"_a, "structure"_a, nb::kw_only(),
      "positions"_a = nb::none(), "overwrite"_a = false, "hybrid36_bonds"_a = false,
      "Writes a PDB file with CONECT records, for programs that read positions from H5MD but\n"
      "names and bonds from elsewhere.\n\n"
      "positions: (N, 3) Angstrom; default: the structure's. hybrid36_bonds: write bonds of\n"
      "atoms past 99,999 too, which MDAnalysis does not open. Raises InputError where a\n"
      "coordinate does not fit the format, FileError where the file exists or cannot be\n"
      "written.");
  bind_graph(module);
}

}  // namespace pliant::python
