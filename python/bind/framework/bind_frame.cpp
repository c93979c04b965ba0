// SPDX-License-Identifier: MIT
// Frame and Stop: what observers are shown.
#include <cmath>

#include "arrays.hpp"
#include "framework/frame.hpp"
#include "pliant/base/error.hpp"
#include "run/pushes.hpp"

namespace pliant::python {
namespace {

/// A frame with a copy of `positions` that is its own.
void make_frame(OwnedFrame* self, std::int64_t step, double time, const ArrayLike& positions,
                std::int64_t sweeps, std::int64_t projections, double max_residual,
                double rms_residual, Stop stop, std::optional<std::int64_t> root_joint,
                const PythonForce& force) {
  if (!std::isfinite(time)) throw InputError("time: is not finite");
  nb::object state = nb::cast(State(positions_from(positions)));
  const auto [x, y, z] = force;
  const std::span<const Vec3> own = nb::cast<const State&>(state).positions;
  new (self) OwnedFrame{{step,
                         time,
                         own,
                         sweeps,
                         projections,
                         max_residual,
                         rms_residual,
                         stop,
                         root_joint.value_or(no_joint),
                         {x, y, z}},
                        std::move(state)};
}

nb::object root_joint_of(const OwnedFrame& self) {
  if (self.frame.root_joint == no_joint) return nb::none();
  return nb::int_(self.frame.root_joint);
}

nb::tuple force_of(const OwnedFrame& self) {
  const Vec3 force = self.frame.force;
  return nb::make_tuple(force.x, force.y, force.z);
}

void bind_stop(nb::module_& module) {
  nb::enum_<Stop>(module, "Stop", "Why a resolve ended.")
      .value("converged", Stop::converged, "Every bar is within the tolerance.")
      .value("max_sweeps", Stop::max_sweeps, "The limit was reached first.")
      .value("not_finite", Stop::not_finite,
             "A length became infinite or not a number; positions were restored.")
      .value("stopped_by_caller", Stop::stopped_by_caller, "The caller asked to stop.");
}

template <auto Field>
auto frame_field() {
  return [](const OwnedFrame& self) { return self.frame.*Field; };
}

}  // namespace

void bind_frame(nb::module_& module) {
  bind_stop(module);
  nb::class_<OwnedFrame>(
      module, "Frame",
      "One step's result, as observers see it.\n\n"
      "``positions`` is a view of the state that the run goes on to change:\n"
      "copy what is to be kept. A frame that you make yourself, for a recorder,\n"
      "holds a copy.")
      .def("__init__", &make_frame, "step"_a, "time"_a, "positions"_a, nb::kw_only(),
           "sweeps"_a = 0, "projections"_a = 0, "max_residual"_a = 0.0, "rms_residual"_a = 0.0,
           "stop"_a = Stop::converged, "root_joint"_a = nb::none(),
           "force"_a = PythonForce{0.0, 0.0, 0.0})
      .def_prop_ro("step", frame_field<&Frame::step>(), "Number of the step.")
      .def_prop_ro("time", frame_field<&Frame::time>(), "Time in ps.")
      .def_prop_ro(
          "positions",
          [](const OwnedFrame& self) { return const_view_of(self.frame.positions, self.owner); },
          nb::rv_policy::reference, "(N, 3) float64, read-only view, Angstrom.")
      .def_prop_ro("sweeps", frame_field<&Frame::sweeps>(), "Sweeps of this step.")
      .def_prop_ro("projections", frame_field<&Frame::projections>(),
                   "Bars looked at in this step.")
      .def_prop_ro("max_residual", frame_field<&Frame::max_residual>(),
                   "Largest |length - rest| / rest.")
      .def_prop_ro("rms_residual", frame_field<&Frame::rms_residual>(),
                   "Root mean square of |length - rest| / rest.")
      .def_prop_ro("stop", frame_field<&Frame::stop>(), "Why resolving ended.")
      .def_prop_ro(
          "converged", [](const OwnedFrame& self) { return self.frame.stop == Stop::converged; },
          "Every bar is within the tolerance.")
      .def_prop_ro("root_joint", &root_joint_of, nb::sig("def root_joint(self) -> int | None"),
                   "The joint where the technique began; None before any step.")
      .def_prop_ro("force", &force_of, nb::sig("def force(self) -> tuple[float, float, float]"),
                   "The force on it, kJ/(mol Angstrom).");
}

}  // namespace pliant::python
