// SPDX-License-Identifier: MIT
// Perturbations: the table.
#include "pliant/perturb/perturbation.hpp"
#include "tables.hpp"

namespace pliant::python {

void bind_perturb(nb::module_& module) {
  bind_row<PerturbationEntry>(module, "PerturbationEntry",
                              "One row of the table of perturbations.");
  module.def(
      "perturbations", [] { return rows_of(perturbations()); }, nb::rv_policy::reference,
      "The table of perturbations: what breaks the bars at the start of a step.");
}

}  // namespace pliant::python
