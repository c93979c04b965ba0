// SPDX-License-Identifier: MIT
// The extension module pliant._core: calls one bind function for each folder of the library.
#include <cstdlib>

#include "bind.hpp"
#include "refusals.hpp"

NB_MODULE(_core, module) {
  using namespace pliant::python;
  // What a script still holds when Python ends (a framework in a traceback, say) is no fault of it:
  // leaks are reported to those who look for them.
  nanobind::set_leak_warnings(std::getenv("PLIANT_REPORT_LEAKS") != nullptr);
  module.doc() = "Compiled part of Pliant; use the names that the package pliant gives.";
  bind_base(module);
  bind_framework(module);
  bind_molecule(module);
  bind_model(module);
  bind_rigidity(module);
  bind_conformers(module);
  bind_network(module);
  bind_plausible_shapes(module);
  bind_sample(module);
  bind_measures(module);
  bind_order(module);
  bind_resolve(module);
  bind_walkers(module);
  bind_perturb(module);
  bind_text(module);
  bind_record(module);
  bind_generate(module);
  bind_guide(module);
  bind_run(module);
  bind_motion(module);
  bind_path(module);
  bind_density_map(module);
  bind_fit(module);
  bind_scattering(module);
  bind_laboratory(module);
  name_unfit_arguments(module);
}
