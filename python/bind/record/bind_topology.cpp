// SPDX-License-Identifier: MIT
// Text files beside trajectories: PDB topologies, and graph XML.
#include <nanobind/stl/filesystem.h>

#include <array>
#include <cstdio>

#include "arrays.hpp"
#include "checks.hpp"
#include "framework/frame.hpp"
#include "messages.hpp"
#include "pliant/jobs/files/molecule_header.hpp"
#include "pliant/molecule/selection.hpp"
#include "pliant/molecule/structure/structure.hpp"
#include "pliant/record/pdb_recorder.hpp"
#include "pliant/record/topology_pdb.hpp"
#include "pliant/record/xml/graph_xml.hpp"
#include "pliant/record/xml/write_graph_xml.hpp"

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

std::string lines_with(const std::vector<std::string>& heads, const ArrayLike& positions,
                       const std::vector<std::string>& tails) {
  const std::vector<Vec3> points = positions_from(positions, heads.size());
  std::string text;
  std::array<char, 64> numbers{};
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Vec3 p = points[k];
    std::snprintf(numbers.data(), numbers.size(), "%8.3f%8.3f%8.3f", p.x, p.y, p.z);
    text.append(heads[k]).append(numbers.data()).append(tails[k]);
  }
  return text;
}

PdbRecorder make_pdb_recorder(const std::filesystem::path& path, const Structure& structure,
                              bool overwrite) {
  TopologyPdbOptions options;
  options.overwrite = overwrite;
  options.title = structure.title;
  options.log = python_log();
  return {path, std::make_shared<const AtomTable>(structure.atoms), recorded_bonds(structure),
          options};
}

void bind_pdb_recorder(nb::module_& module) {
  nb::class_<PdbRecorder>(
      module, "PdbRecorder",
      "Writes frames as the models of one PDB file, for viewers.\n\n"
      "The file takes its name when it is closed with at least one model; what is not closed is\n"
      "deleted. Positions are rounded to 0.001 Angstrom; steps and times have no place in it.\n"
      "An observer of runs: it can be called with a frame.\n\n"
      "Raises InputError where a coordinate does not fit the format (-999.999 to 9999.999),\n"
      "FileError where the file exists (and ``overwrite`` is false) or cannot be written.")
      .def(
          "__init__",
          [](PdbRecorder* self, const std::filesystem::path& path, const Structure& structure,
             bool overwrite) {
            new (self) PdbRecorder(make_pdb_recorder(path, structure, overwrite));
          },
          "path"_a, "structure"_a, nb::kw_only(), "overwrite"_a = false)
      .def(
          "record",
          [](PdbRecorder& self, const ArrayLike& positions) {
            self.record(positions_from(positions));
          },
          "positions"_a, "Adds a model of positions (N, 3), Angstrom.")
      .def(
          "__call__", [](PdbRecorder& self, const OwnedFrame& frame) { self.record(frame.frame); },
          "frame"_a, "Adds a frame, so that it is an observer.")
      .def("close", &PdbRecorder::close, "Ends the file and gives it its name.")
      .def_prop_ro("models", &PdbRecorder::models, "Models recorded.")
      .def_prop_ro("path", &PdbRecorder::path, "Where the file is.")
      .def(
          "__enter__", [](nb::handle_t<PdbRecorder> self) { return nb::borrow(self); },
          nb::sig("def __enter__(self) -> PdbRecorder"))
      .def(
          "__exit__",
          [](PdbRecorder& self, nb::handle type, nb::handle, nb::handle) {
            if (type.is_none()) self.close();
          },
          "type"_a.none(), "value"_a.none(), "traceback"_a.none(),
          nb::sig("def __exit__(self, type: object, value: object, traceback: object) -> None"),
          "Closes it, unless there was an exception.");
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
  module.def("pdb_lines", &lines_with, "heads"_a, "positions"_a, "tails"_a,
             nb::sig("def pdb_lines(heads: collections.abc.Sequence[str], "
                     "positions: numpy.typing.ArrayLike, "
                     "tails: collections.abc.Sequence[str]) -> str"),
             "Lines of atoms: what stands before their coordinates (N, 3), and what after.");
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
  module.def(
      "select_atoms",
      [](const Structure& structure, const std::string& selection) {
        return array_of(select_atoms(structure.atoms, selection));
      },
      "structure"_a, "selection"_a,
      "Indices (n,) of the atoms that a selection names, ascending. Raises OptionError where it\n"
      "cannot be understood.");
  bind_pdb_recorder(module);
  bind_graph(module);
}

}  // namespace pliant::python
