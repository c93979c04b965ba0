// SPDX-License-Identifier: MIT
// Perturbations: the table, and force files.
#include "pliant/perturb/perturbation.hpp"

#include <nanobind/stl/filesystem.h>

#include "pliant/perturb/force_file.hpp"
#include "pushes.hpp"
#include "tables.hpp"

namespace pliant::python {
namespace {

void bind_force_file(nb::module_& module) {
  nb::class_<ForceFile>(module, "ForceFile",
                        "Pushes to be replayed, and the settings that they were made for.")
      .def(nb::init<>())
      .def_rw("timestep", &ForceFile::timestep, "ps; None where the file does not say.")
      .def_rw("tolerance", &ForceFile::tolerance, "Relative; None where the file does not say.")
      .def_rw("tolerance_length", &ForceFile::tolerance_length,
              "Angstrom; None where the file does not say.")
      .def_rw("max_sweeps", &ForceFile::max_sweeps, "None where the file does not say.")
      .def_prop_rw(
          "pushes", [](const ForceFile& self) { return pushes_to_python(self.pushes); },
          [](ForceFile& self, const PythonPushes& pushes) { self.pushes = pushes_from(pushes); },
          "(joint, (x, y, z)) in kJ/(mol Angstrom), one a step.")
      .def(
          "text",
          [](const ForceFile& self, const Framework& framework) {
            for (const JointForce& push : self.pushes) joint_at(framework, push.joint);
            return write_force_file(self, framework);
          },
          "framework"_a, "The file's text, which reads back to the same bits.");
  module.def("read_force_file", &read_force_file, "path"_a, "framework"_a,
             nb::call_guard<nb::gil_scoped_release>(),
             "Reads a force file; joints are named as the framework names them, or by index.");
}

}  // namespace

void bind_perturb(nb::module_& module) {
  bind_row<PerturbationEntry>(module, "PerturbationEntry",
                              "One row of the table of perturbations.");
  module.def(
      "perturbations", [] { return rows_of(perturbations()); }, nb::rv_policy::reference,
      "The table of perturbations: what breaks the bars at the start of a step.");
  bind_force_file(module);
}

}  // namespace pliant::python
