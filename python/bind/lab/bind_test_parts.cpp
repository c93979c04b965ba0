// SPDX-License-Identifier: MIT
#include "lab/test_parts.hpp"

#include <nanobind/stl/filesystem.h>

#include "pliant/base/system/path_text.hpp"
#include "pliant/resolve/techniques.hpp"
#include "resolve/orderings.hpp"
#include "run/pushes.hpp"

namespace pliant::python {
namespace {

nb::list graphs_of(const ClassPart& self) {
  nb::list parts;
  for (const TestGraph& row : self.row->graphs) parts.append(GraphPart{&row, self.set});
  return parts;
}

nb::list heuristics_of(const GraphPart& self) {
  nb::list parts;
  for (const TestHeuristic& row : self.row->heuristics)
    parts.append(HeuristicPart{{&row, self.set}, self.row});
  return parts;
}

void bind_results(nb::module_& module) {
  nb::class_<TestSummary>(module, "TestResults",
                          "Statistics of the sweeps of a heuristic for the forces of a graph.")
      .def_ro("forces", &TestSummary::forces, "Number of forces.")
      .def_ro("converged", &TestSummary::converged, "Number of forces that converged.")
      .def_ro("mean", &TestSummary::mean, "Mean.")
      .def_ro("mode", &TestSummary::mode, "The smallest of the most frequent values.")
      .def_ro("sd", &TestSummary::sd, "Standard deviation with n - 1; 0 for one force.")
      .def("__eq__", [](const TestSummary& one, const TestSummary& two) { return one == two; });
  nb::class_<HeuristicPart>(module, "TestHeuristic", "A technique with a weighting.")
      .def_prop_ro(
          "technique", [](const HeuristicPart& self) { return self.row->technique; },
          "A name in ``techniques()``.")
      .def_prop_ro(
          "weighting", [](const HeuristicPart& self) { return self.row->weighting; },
          "Share of a correction that the far joint of a tree bar takes.")
      .def_prop_ro(
          "name", [](const HeuristicPart& self) { return self.row->name(); },
          "\"bfs_cycle-0.5\": its folder.")
      .def_prop_ro(
          "directory",
          [](const HeuristicPart& self) {
            return self.folder(test_set_paths::heuristic(*self.graph, *self.row));
          },
          "Where its results.csv is, or will be.")
      .def_prop_ro(
          "results", [](const HeuristicPart& self) { return self.row->results; },
          "None until results were written.");
}

void bind_graphs(nb::module_& module) {
  nb::class_<GraphPart>(module, "TestGraph", "A graph of a test set with its forces.")
      .def_prop_ro(
          "name",
          [](const GraphPart& self) { return path_text(path_of(self.row->folder).filename()); },
          "\"graph-003\": its folder.")
      .def_prop_ro(
          "number", [](const GraphPart& self) { return self.row->number; },
          "Number of the graph in its class, from 0; ``number`` of ``generate``.")
      .def_prop_ro(
          "directory", [](const GraphPart& self) { return self.folder(self.row->folder); },
          "Its folder.")
      .def_prop_ro(
          "graph", [](const GraphPart& self) { return self.row->graph; },
          "A Graph of your own: framework, positions at which all bars are whole, cycles.")
      .def_prop_ro(
          "pushes", [](const GraphPart& self) { return pushes_to_python(self.row->pushes()); },
          "(joint, (x, y, z)) in kJ/(mol Angstrom), of all force files in their order.")
      .def_prop_ro(
          "ordering", [](const GraphPart& self) { return ordering_to_python(self.row->ordering); },
          nb::sig("def ordering(self) -> tuple[numpy.typing.NDArray[numpy.uint32], "
                  "numpy.typing.NDArray[numpy.uint32], numpy.typing.NDArray[numpy.bool_]]"),
          "The ordering of its ordering file: (bar, near, is_tree).")
      .def_prop_ro("heuristics", &heuristics_of,
                   nb::sig("def heuristics(self) -> list[TestHeuristic]"),
                   "In the order of results.xml.");
  nb::class_<ClassPart>(module, "TestClass", "The graphs of one class in a test set.")
      .def_prop_ro(
          "name", [](const ClassPart& self) { return self.row->name; },
          "A name in ``graph_classes()``.")
      .def_prop_ro(
          "family", [](const ClassPart& self) { return self.row->family; },
          "\"tree\", \"1-cycle\", \"2-cycle\" or \"n-cycle\".")
      .def_prop_ro("graphs", &graphs_of, nb::sig("def graphs(self) -> list[TestGraph]"),
                   "By their number.");
}

}  // namespace

void bind_test_parts(nb::module_& module) {
  bind_results(module);
  bind_graphs(module);
}

}  // namespace pliant::python
