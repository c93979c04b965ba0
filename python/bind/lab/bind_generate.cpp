// SPDX-License-Identifier: MIT
// Generated frameworks: random graphs of the classes of the thesis.
#include "pliant/lab/generate/random_graphs.hpp"

#include "pliant/record/xml/graph_xml.hpp"
#include "tables.hpp"

namespace pliant::python {
namespace {

GraphFile generate_graph(const std::string& kind, std::uint64_t seed, std::uint64_t number,
                         std::int64_t depth, std::int64_t children, std::int64_t ring,
                         std::int64_t cycles, std::int64_t joints, double box) {
  const GraphClass& row = find_graph_class(kind);
  const GenerateOptions options{depth, children, ring, cycles, joints, box};
  RandomKey key;
  key.seed = seed;
  key.walker = number;
  const nb::gil_scoped_release no_gil;
  GeneratedGraph made = generate(row, options, key);
  return {std::move(made.framework), std::move(made.positions), std::move(made.cycles)};
}

constexpr const char* generate_doc =
    R"(A random framework of a class, at positions where all bars are whole.

Thesis "Motion Simulation of Geometric Constraint Structures", sections 3.2 and 3.3.

Parameters
----------
kind : str
    A name in ``graph_classes()``.
seed, number : int
    Number of the graph among those of the class: the same numbers give the same graph.
depth : int
    Levels of a tree below its root, from 1.
children : int
    Most children of a joint, from 1 (the number is random).
ring : int
    Most joints of a closed chain, from 3 (the number is random).
cycles : int
    Non-tree bars of an n-cycle, from 0.
joints : int
    Joints of a tree; 0: determined by depth and children.
box : float
    Edge of the box that positions are drawn from, Angstrom.

Raises
------
OptionError
    An unknown class, or an option out of its range.
)";

}  // namespace

void bind_generate(nb::module_& module) {
  bind_row<GraphClass>(module, "GraphClass", "One row of the table of classes of random graphs.")
      .def_ro("family", &GraphClass::family, "\"tree\", \"1-cycle\", \"2-cycle\" or \"n-cycle\".");
  module.def(
      "graph_classes", [] { return rows_of(graph_classes()); }, nb::rv_policy::reference,
      "The table of classes of random graphs.");
  const GenerateOptions options;
  module.def("generate", &generate_graph, "kind"_a, "seed"_a = 0, "number"_a = 0, nb::kw_only(),
             "depth"_a = options.depth, "children"_a = options.children, "ring"_a = options.ring,
             "cycles"_a = options.cycles, "joints"_a = options.joints, "box"_a = options.box,
             generate_doc);
}

}  // namespace pliant::python
