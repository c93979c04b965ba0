// SPDX-License-Identifier: MIT
// The summary of a run.
#include "arrays.hpp"
#include "run/observers.hpp"

namespace pliant::python {
namespace {

void bind_kept(nb::class_<OwnedRunSummary>& summary) {
  summary
      .def(
          "__init__",
          [](OwnedRunSummary* self, OwnedRunSummary& other) {
            new (self) OwnedRunSummary(std::move(other));
          },
          "other"_a, "Takes what ``other`` holds.")
      .def_prop_ro(
          "kept",
          [](nb::handle_t<OwnedRunSummary> self) {
            return view_of(nb::cast<OwnedRunSummary&>(self).kept, self);
          },
          "(F * N, 3) float64 view, Angstrom: frames that were kept in memory.");
}

}  // namespace

void bind_run_summary(nb::module_& module) {
  nb::class_<OwnedRunSummary> summary(module, "RunSummary", "What a run did.");
  bind_kept(summary);
  summary
      .def_ro("state", &OwnedRunSummary::state, nb::sig("def state(self) -> State"),
              "What the run moved: its last positions.")
      .def_ro("steps", &RunSummary::steps, "Steps done.")
      .def_ro("frames", &RunSummary::frames, "Frames shown to observers.")
      .def_ro("unconverged_steps", &RunSummary::unconverged_steps,
              "Steps after which some bar missed the tolerance.")
      .def_ro("first_unconverged_step", &RunSummary::first_unconverged_step,
              "The first of them; -1 if none.")
      .def_ro("sweeps", &RunSummary::sweeps, "Sweeps of all steps.")
      .def_ro("max_sweeps", &RunSummary::max_sweeps, "Sweeps of the step that needed most.")
      .def_ro("projections", &RunSummary::projections, "Bars looked at in all steps.")
      .def_ro("worst_residual", &RunSummary::worst_residual,
              "Largest |length - rest| / rest after any step.")
      .def_ro("worst_bar", &RunSummary::worst_bar, "Its bar.")
      .def_ro("worst_step", &RunSummary::worst_step, "Its step.")
      .def_ro("stopped_by_caller", &RunSummary::stopped_by_caller, "An observer asked to stop.")
      .def_ro("perturb_seconds", &RunSummary::perturb_seconds, "Wall time of perturbing.")
      .def_ro("resolve_seconds", &RunSummary::resolve_seconds, "Wall time of resolving.")
      .def_ro("observe_seconds", &RunSummary::observe_seconds, "Wall time of the observers.")
      .def_ro("seconds", &RunSummary::seconds, "Wall time of it all.")
      .def_prop_ro(
          "converged", [](const OwnedRunSummary& self) { return self.unconverged_steps == 0; },
          "Every bar was within the tolerance after every step.")
      .def_prop_ro(
          "mean_sweeps", [](const OwnedRunSummary& self) { return self.mean_sweeps(); },
          "Mean number of sweeps a step.")
      .def_prop_ro(
          "ns_per_bar_and_sweep",
          [](const OwnedRunSummary& self) { return self.ns_per_bar_and_sweep(); },
          "Resolve time over projections, nanoseconds.")
      .def("__repr__", [](const OwnedRunSummary& self) {
        return "<pliant.RunSummary: " + std::to_string(self.steps) + " steps, " +
               std::to_string(self.frames) + " frames, " + std::to_string(self.unconverged_steps) +
               " unconverged>";
      });
}

}  // namespace pliant::python
