// SPDX-License-Identifier: MIT
// The parts of the extension module: one function for each folder of the library.
#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/string_view.h>
#include <nanobind/stl/vector.h>

namespace pliant::python {

namespace nb = nanobind;
using namespace nb::literals;

void bind_base(nb::module_& module);
void bind_conformers(nb::module_& module);
void bind_density_map(nb::module_& module);
void bind_framework(nb::module_& module);
void bind_generate(nb::module_& module);
void bind_guide(nb::module_& module);
void bind_laboratory(nb::module_& module);
void bind_measures(nb::module_& module);
void bind_model(nb::module_& module);
void bind_molecule(nb::module_& module);
void bind_motion(nb::module_& module);
void bind_network(nb::module_& module);
void bind_order(nb::module_& module);
void bind_resolve(nb::module_& module);
void bind_path(nb::module_& module);
void bind_fit(nb::module_& module);
void bind_plausible_shapes(nb::module_& module);
void bind_perturb(nb::module_& module);
void bind_record(nb::module_& module);
void bind_rigidity(nb::module_& module);
void bind_run(nb::module_& module);
void bind_run_summary(nb::module_& module);
void bind_sample(nb::module_& module);
void bind_scattering(nb::module_& module);
void bind_text(nb::module_& module);
void bind_walkers(nb::module_& module);

}  // namespace pliant::python
