// SPDX-License-Identifier: MIT
// The table of example frameworks with known facts.
#include <nanobind/stl/optional.h>

#include "arrays.hpp"
#include "pliant/lab/examples/examples.hpp"

namespace pliant::python {

void bind_examples(nb::module_& module);

namespace {

void bind_facts(nb::module_& module) {
  nb::class_<ExampleFacts>(module, "ExampleFacts",
                           "What is known of an example from closed forms, the literature or "
                           "another program.")
      .def_ro("components", &ExampleFacts::components, "Connected components.")
      .def_ro("cycles", &ExampleFacts::cycles, "Independent cycles.")
      .def_ro("bridges", &ExampleFacts::bridges, "Bars on no cycle.")
      .def_ro("blocks", &ExampleFacts::blocks, "Biconnected components of two or more bars.")
      .def_ro("feasible", &ExampleFacts::feasible,
              "Some positions have every bar at its rest length.")
      .def_ro("whole", &ExampleFacts::whole, "The positions of the example are so.")
      .def_ro("rank", &ExampleFacts::rank, "Rank of the rigidity matrix; None if not known.")
      .def_ro("rigid_motions", &ExampleFacts::rigid_motions, "Independent rigid motions: 3, 5, 6.")
      .def_ro("flexes", &ExampleFacts::flexes, "True internal degrees of freedom, in space.");
}

std::vector<const Example*> all_examples() {
  std::vector<const Example*> rows;
  for (const Example& example : examples()) rows.push_back(&example);
  return rows;
}

}  // namespace

void bind_examples(nb::module_& module) {
  bind_facts(module);
  nb::class_<Example>(module, "Example", "A tiny named framework with known properties.")
      .def_ro("name", &Example::name, "Name of the example.")
      .def_ro("source", &Example::source, "Where its facts come from.")
      .def_ro("framework", &Example::framework, "The framework.")
      .def_ro("facts", &Example::facts, "Its known properties.")
      .def_prop_ro(
          "positions", [](const Example& self) { return new_positions(self.positions); },
          nb::rv_policy::reference, "(N, 3) float64, Angstrom: a new array.")
      .def("__repr__",
           [](const Example& self) { return "<pliant.Example: " + std::string(self.name) + ">"; });
  module.def("examples", &all_examples, nb::rv_policy::reference,
             "The table of examples: frameworks of the thesis, of rigidity theory, and families.");
}

}  // namespace pliant::python
