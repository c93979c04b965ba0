// SPDX-License-Identifier: MIT
// Test sets: graphs, forces, orderings and results in the folders of figure 4.6 of the thesis.
#include <nanobind/stl/filesystem.h>

#include "arrays.hpp"
#include "lab/test_parts.hpp"
#include "pliant/base/error.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/lab/test_sets/make_test_set.hpp"
#include "pliant/lab/test_sets/read_test_set.hpp"
#include "pliant/lab/test_sets/test_set.hpp"
#include "pliant/resolve/techniques.hpp"

namespace pliant::python {
namespace {

nb::list classes_of(nb::handle_t<TestSet> self) {
  nb::list parts;
  for (const TestClass& row : nb::cast<TestSet&>(self).classes)
    parts.append(ClassPart{&row, nb::borrow(self)});
  return parts;
}

TestSet write_set(const std::filesystem::path& directory,
                  const std::optional<std::vector<std::string>>& classes, std::int64_t graphs,
                  std::int64_t forces, std::int64_t force_files, std::uint64_t seed,
                  const std::optional<std::vector<std::string>>& techniques,
                  const std::vector<double>& weightings, std::int64_t depth, std::int64_t children,
                  std::int64_t ring, std::int64_t cycles, std::int64_t joints, double box,
                  double force, double timestep, double tolerance_length, std::int64_t max_sweeps) {
  TestSetOptions options;
  options.settings = {seed,
                      forces,
                      force,
                      timestep,
                      tolerance_length,
                      max_sweeps,
                      {depth, children, ring, cycles, joints, box}};
  options.classes = classes.value_or(std::vector<std::string>{});
  options.techniques = techniques.value_or(std::vector<std::string>{});
  options.weightings = weightings;
  options.graphs = graphs;
  options.force_files = force_files;
  const nb::gil_scoped_release no_gil;
  return make_test_set(directory, options);
}

std::vector<TestRow> rows_from(const ArrayLike& sweeps, const ArrayLike& passes,
                               const ArrayLike& projections, const ArrayLike& converged,
                               const ArrayLike& final_residual) {
  const auto counts = integers_from(sweeps, "sweeps"), back = integers_from(passes, "passes"),
             looks = integers_from(projections, "projections");
  const auto whole = truths_from(converged, "converged");
  const auto residuals = reals_from(final_residual, "final_residual");
  for (std::size_t size : {back.size(), looks.size(), whole.size(), residuals.size()})
    if (size != counts.size())
      throw InputError("results: expected five columns of one length, found " +
                       std::to_string(counts.size()) + " and " + std::to_string(size));
  std::vector<TestRow> rows;
  for (std::size_t k = 0; k < counts.size(); ++k)
    rows.push_back({counts[k], back[k], looks[k], bool(whole[k]), residuals[k]});
  return rows;
}

nb::dict columns_of(const std::vector<TestRow>& rows) {
  std::vector<std::int64_t> force, sweeps, passes, projections;
  std::vector<bool> converged;
  std::vector<double> residual;
  for (const TestRow& row : rows) {
    force.push_back(std::int64_t(force.size()));
    sweeps.push_back(row.sweeps);
    passes.push_back(row.passes);
    projections.push_back(row.projections);
    converged.push_back(row.converged);
    residual.push_back(row.final_residual);
  }
  nb::dict columns;
  columns["force"] = array_of(std::move(force));
  columns["sweeps"] = array_of(std::move(sweeps));
  columns["passes"] = array_of(std::move(passes));
  columns["projections"] = array_of(std::move(projections));
  columns["converged"] = mask_of(converged);
  columns["final_residual"] = array_of(std::move(residual));
  return columns;
}

template <auto Member>
auto setting = [](const TestSet& self) { return self.settings.*Member; };
template <auto Member>
auto size = [](const TestSet& self) { return self.settings.sizes.*Member; };

void bind_settings(nb::class_<TestSet>& set) {
  set.def_prop_ro("seed", setting<&TestSettings::seed>, "Seed of all random numbers.")
      .def_prop_ro("forces", setting<&TestSettings::forces>, "Number of pushes for each graph.")
      .def_prop_ro("force", setting<&TestSettings::force>, "Size of each, kJ/(mol Angstrom).")
      .def_prop_ro("timestep", setting<&TestSettings::timestep>, "ps.")
      .def_prop_ro("tolerance_length", setting<&TestSettings::tolerance_length>,
                   "Largest |length - rest| of a whole bar, Angstrom.")
      .def_prop_ro("max_sweeps", setting<&TestSettings::max_sweeps>,
                   "Sweeps after which a resolve is given up.")
      .def_prop_ro("depth", size<&GenerateOptions::depth>, "As for ``generate``.")
      .def_prop_ro("children", size<&GenerateOptions::children>, "As for ``generate``.")
      .def_prop_ro("ring", size<&GenerateOptions::ring>, "As for ``generate``.")
      .def_prop_ro("cycles", size<&GenerateOptions::cycles>, "As for ``generate``.")
      .def_prop_ro("joints", size<&GenerateOptions::joints>, "As for ``generate``.")
      .def_prop_ro("box", size<&GenerateOptions::box>, "As for ``generate``, Angstrom.");
}

constexpr const char* write_results_doc =
    R"(Writes results.csv of one heuristic of one graph, in one go, replacing an old one.

``save`` puts its summary into results.xml. A heuristic that the set does not name yet is added.

Parameters
----------
kind : str
    Name of the class.
graph : int
    Number of the graph in it.
technique, weighting : str, float
sweeps, passes, projections : (F,) int
    Numbers for each force, in the order of ``pushes``. In ``passes`` forwards and backwards of a
    reverse technique count as one.
converged : (F,) bool
final_residual : (F,) float
    Largest \|length - rest\| / rest at the end.

Raises
------
OptionError
    No such class, graph or technique.
InputError
    Not one row per push, a negative number, a residual that is not finite.
FileError
    The file cannot be written.
)";

void bind_set(nb::module_& module) {
  nb::class_<TestSet> set(
      module, "TestSet",
      "Graphs, forces, orderings and results in folders (thesis, figure 4.6).\n\n"
      "``read_test_set`` and ``write_test_set`` make it. For one thread.");
  set.def_prop_ro(
         "directory", [](const TestSet& self) { return path_text(self.directory); },
         "The folder that results.xml is in.")
      .def_prop_ro("classes", &classes_of, nb::sig("def classes(self) -> list[TestClass]"),
                   "In the order of results.xml.")
      .def(
          "class_named",
          [](nb::handle_t<TestSet> self, const std::string& name) {
            return ClassPart{&nb::cast<TestSet&>(self).class_named(name), nb::borrow(self)};
          },
          "name"_a, nb::sig("def class_named(self, name: str) -> TestClass"),
          "Returns the class of that name. Raises OptionError listing the existing names.")
      .def(
          "write_results",
          [](TestSet& self, const std::string& kind, std::int64_t graph,
             const std::string& technique, double weighting, const ArrayLike& sweeps,
             const ArrayLike& passes, const ArrayLike& projections, const ArrayLike& converged,
             const ArrayLike& final_residual) {
            return self.write_results(
                {kind, graph, technique, weighting},
                rows_from(sweeps, passes, projections, converged, final_residual));
          },
          "kind"_a, "graph"_a, "technique"_a, "weighting"_a, "sweeps"_a, "passes"_a,
          "projections"_a, "converged"_a, "final_residual"_a, write_results_doc)
      .def(
          "read_results",
          [](const TestSet& self, const std::string& kind, std::int64_t graph,
             const std::string& technique, double weighting) {
            return columns_of(self.read_results({kind, graph, technique, weighting}));
          },
          "kind"_a, "graph"_a, "technique"_a, "weighting"_a,
          nb::sig("def read_results(self, kind: str, graph: int, technique: str, "
                  "weighting: float) -> dict[str, numpy.typing.NDArray]"),
          "The columns of results.csv, each (F,), and ``force``, by name.\n\n"
          "Raises OptionError where there are no results, InputError where they are not those "
          "that\n"
          "results.xml sums up.")
      .def("save", &TestSet::save, nb::call_guard<nb::gil_scoped_release>(),
           "Writes results.xml again, atomically.");
  bind_settings(set);
}

constexpr const char* write_doc =
    R"(Makes random graphs, forces and orderings and writes them as a test set.

StructGen's test mode and ForceGen of the thesis "Motion Simulation of Geometric Constraint
Structures", sections 3.3 and 4.1, figure 4.6. Graph k of a class is ``generate(kind, seed, k)``,
its forces are ``make_force_file(framework, seed=seed, walker=k)``; its ordering file holds
bfs_cycle from joint 0. The same arguments give the same files.

Parameters
----------
directory : path
    New or empty.
classes : list of str, optional
    Names in ``graph_classes()``; None: all.
graphs, forces : int
    Graphs of each class, pushes of each graph.
force_files : int
    Number of files for the pushes of a graph.
seed : int
techniques : list of str, optional
    Names in ``techniques()``, in the classes that each can resolve; None: every ordering but
    ``input``.
weightings : list of float
depth, children, ring, cycles, joints, box
    As for ``generate``.
force, timestep, tolerance_length, max_sweeps
    Of the force files: kJ/(mol Angstrom), ps, Angstrom.

Raises
------
OptionError
    An option is out of its range; the message names it.
FileError
    The folder is not empty, or a file cannot be written.
)";

}  // namespace

void bind_laboratory(nb::module_& module) {
  bind_test_parts(module);
  bind_set(module);
  const TestSetOptions options;
  const TestSettings settings;
  const GenerateOptions sizes;
  module.def("write_test_set", &write_set, "directory"_a, nb::kw_only(), "classes"_a = nb::none(),
             "graphs"_a = options.graphs, "forces"_a = settings.forces,
             "force_files"_a = options.force_files, "seed"_a = settings.seed,
             "techniques"_a = nb::none(), "weightings"_a = options.weightings,
             "depth"_a = sizes.depth, "children"_a = sizes.children, "ring"_a = sizes.ring,
             "cycles"_a = sizes.cycles, "joints"_a = sizes.joints, "box"_a = sizes.box,
             "force"_a = settings.force, "timestep"_a = settings.timestep,
             "tolerance_length"_a = settings.tolerance_length, "max_sweeps"_a = settings.max_sweeps,
             write_doc);
  module.def("read_test_set", &read_test_set, "directory"_a,
             nb::call_guard<nb::gil_scoped_release>(),
             "Reads results.xml of a test set and every graph, ordering and force file that it "
             "names.\n\n"
             "Raises InputError naming file, line, what was expected and what was found, and "
             "FileError.");
}

}  // namespace pliant::python
