// SPDX-License-Identifier: MIT
// Perturbations: the table, and force files.
#include "pliant/perturb/perturbation.hpp"

#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/map.h>

#include "options.hpp"
#include "pliant/framework/fingerprint.hpp"
#include "pliant/perturb/force_files/force_file.hpp"
#include "pliant/perturb/replay.hpp"
#include "run/pushers.hpp"
#include "run/pushes.hpp"
#include "tables.hpp"

namespace pliant::python {
namespace {

ForceFile random_force_file(const Framework& framework, std::int64_t count, double force,
                            std::uint64_t seed, std::uint64_t walker, double timestep,
                            double tolerance, std::optional<double> tolerance_length,
                            std::int64_t max_sweeps) {
  PerturbOptions options;
  options.force = force;
  options.timestep = timestep;
  RandomKey key;
  key.seed = seed;
  key.walker = walker;
  const Tolerance within = tolerance_from(tolerance, tolerance_length);
  ResolveOptions resolve;
  resolve.tolerance = within;
  resolve.max_sweeps = max_sweeps;
  check(resolve);
  const nb::gil_scoped_release no_gil;
  ForceFile file = make_force_file(framework, options, within, max_sweeps, key, count);
  file.header = force_header_of(framework);
  return file;
}

using TextByName = std::map<std::string, std::string>;

TextByName by_name(const std::vector<ForceSetting>& settings) {
  TextByName values;
  for (const ForceSetting& one : settings) values[one.name] = one.value;
  return values;
}

/// What the file was made for.
void bind_header(nb::class_<ForceFile>& file) {
  file.def_prop_ro(
          "structure",
          [](const ForceFile& self) -> std::optional<std::string> {
            if (!self.header.structure) return {};
            return fingerprint_text(*self.header.structure);
          },
          "Fingerprint of the structure, 16 hexadecimal digits; None where it is not known.")
      .def_prop_ro(
          "joints", [](const ForceFile& self) { return self.header.joints; },
          "How many the framework has; None where the file does not say.")
      .def_prop_ro(
          "bars", [](const ForceFile& self) { return self.header.bars; },
          "How many the framework has; None where the file does not say.")
      .def_prop_ro(
          "input", [](const ForceFile& self) { return by_name(self.header.input); },
          "Options that make the framework of the structure: ``{\"model\": \"protein\"}``.")
      .def_prop_ro(
          "settings", [](const ForceFile& self) { return by_name(self.settings); },
          "Options of the run besides those above, as text: ``{\"technique\": \"blocks\"}``.");
}

void bind_force_file(nb::module_& module) {
  nb::class_<ForceFile> file(module, "ForceFile",
                             "Pushes to be replayed, and the settings that they were made for.");
  bind_header(file);
  file.def(nb::init<>())
      .def_rw("timestep", &ForceFile::timestep, "ps; None where the file does not say.")
      .def_rw("tolerance", &ForceFile::tolerance, "Relative; None where the file does not say.")
      .def_rw("tolerance_length", &ForceFile::tolerance_length,
              "Angstrom; None where the file does not say.")
      .def_rw("max_sweeps", &ForceFile::max_sweeps, "None where the file does not say.")
      .def_prop_rw(
          "pushes", [](const ForceFile& self) { return pushes_to_python(self.pushes); },
          [](ForceFile& self, const PythonPushes& pushes) { self.pushes = pushes_from(pushes); },
          "(joint, (x, y, z)) in kJ/(mol Angstrom), one per step, or as ``counts`` says.")
      .def_rw("counts", &ForceFile::counts, "Pushes in each step; empty: one.")
      .def(
          "text",
          [](const ForceFile& self, const Framework& framework) {
            for (const JointForce& push : self.pushes) joint_at(framework, push.joint);
            check_counts(self.pushes, self.counts);
            return write_force_file(self, framework);
          },
          "framework"_a, "The file's text, which reads back to the same bits.");
  const PerturbOptions perturb;
  const ResolveOptions resolve;
  module.def(
      "make_force_file", &random_force_file, "framework"_a, "count"_a = 50, nb::kw_only(),
      "force"_a = perturb.force, "seed"_a = 0, "walker"_a = 0, "timestep"_a = perturb.timestep,
      "tolerance"_a = resolve.tolerance.relative, "tolerance_length"_a = nb::none(),
      "max_sweeps"_a = resolve.max_sweeps,
      "Random pushes: those that ``run`` meets with the same force, seed and walker.\n\n"
      "Each is a force of size ``force``, kJ/(mol Angstrom), in a random direction on a\n"
      "random joint that is not pinned. The other arguments are noted in the file; they are\n"
      "as of ``run``. Raises OptionError if all joints are pinned.");
  module.def("read_force_file", &read_force_file, "path"_a, "framework"_a,
             nb::call_guard<nb::gil_scoped_release>(),
             "Reads a force file; joints are named as the framework names them, or by index.\n\n"
             "Raises InputError, also where the file was made for another number of joints or\n"
             "bars, and for one that holds what was done by hand: ``pliant run --forces`` repeats\n"
             "that.");
}

}  // namespace

void bind_perturb(nb::module_& module) {
  bind_row<PerturbationEntry>(module, "PerturbationEntry",
                              "One row of the table of perturbations.");
  module.def(
      "perturbations", [] { return rows_of(perturbations()); }, nb::rv_policy::reference,
      "The table of perturbations: what breaks the bars at the start of a step.");
  bind_pushers(module);
  bind_force_file(module);
}

}  // namespace pliant::python
