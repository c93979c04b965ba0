// SPDX-License-Identifier: MIT
// Steering, the table of pushers, and pushers written in Python.
#include "run/pushers.hpp"

#include <nanobind/stl/shared_ptr.h>

#include "arrays.hpp"
#include "pliant/perturb/pushers.hpp"
#include "pliant/perturb/steering.hpp"
#include "run/pushes.hpp"
#include "tables.hpp"

namespace pliant::python {
namespace {

/// Calls a Python object with the step, the positions to move and those before the step.
class PythonPusher final : public PusherOfPython {
 public:
  PythonPusher(nb::handle callable, nb::handle state)
      : callable_(nb::borrow(callable)), state_(nb::borrow(state)) {}

  ~PythonPusher() override {
    const nb::gil_scoped_acquire gil;
    callable_.reset();
    state_.reset();
  }

  nb::handle object() const override { return callable_; }
  void forget_object() override { callable_.reset(); }

  bool push(const PushCall& call, State& state, Push& out) override {
    {
      const nb::gil_scoped_acquire gil;
      const nb::object moved =
          callable_(state.step + 1, view_of(state.positions, state_),
                    const_view_of(std::span<const Vec3>(state.previous), state_));
      note(moved, call.framework, out);
    }
    put_back_what_stays(call.framework, state);
    return true;
  }

 private:
  static void note(const nb::object& moved, const Framework& framework, Push& out) {
    if (moved.is_none()) return out.add_all(framework.joint_count() == 0 ? no_joint : 0);
    for (Joint joint : joints_from({moved}, "moved", framework.joint_count())) out.add(joint);
  }

  /// Pinned joints, and the height of what lies in a plane.
  static void put_back_what_stays(const Framework& framework, State& state) {
    if (!framework.has_pinned_joints() && !framework.is_planar()) return;
    for (Joint joint = 0; joint < state.positions.size(); ++joint) {
      if (framework.is_pinned(joint)) state.positions[joint] = state.previous[joint];
      if (framework.is_planar()) state.positions[joint].z = state.previous[joint].z;
    }
  }

  nb::object callable_, state_;
};

void bind_steering(nb::module_& module) {
  nb::class_<Steering>(
      module, "Steering",
      "Forces that another thread sets: a mouse, a socket. Give it to ``Motion.add``.\n\n"
      "What is asked during a step acts from the next one on; the same forces in each step give\n"
      "the same bits. Serves one Motion.")
      .def(nb::init<>())
      .def(
          "pull",
          [](Steering& self, const PythonPushes& forces) { self.pull(pushes_from(forces)); },
          "forces"_a,
          "From the next step on these act, in place of those before: (joint, (x, y, z)) in\n"
          "kJ/(mol Angstrom). Forces on one joint add up. Raises OptionError if one is not "
          "finite.")
      .def("release", &Steering::release, "Nothing pulls from the next step on.");
}

}  // namespace

std::shared_ptr<Pusher> pusher_from(nb::handle object, nb::handle_t<State> state) {
  if (nb::isinstance<Steering>(object)) return nb::cast<std::shared_ptr<Steering>>(object);
  if (PyCallable_Check(object.ptr()) != 0) return std::make_shared<PythonPusher>(object, state);
  throw nb::type_error("pusher: expected a Steering or something to be called");
}

void bind_pushers(nb::module_& module) {
  bind_steering(module);
  module.def(
      "pushers", [] { return rows_of(pushers()); }, nb::rv_policy::reference,
      "The table of pushers: those of ``perturbations()``, ``replay``, and those that follow a\n"
      "``Guide``. They combine.");
}

}  // namespace pliant::python
