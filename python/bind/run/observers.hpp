// SPDX-License-Identifier: MIT
// Observers in Python: recorders, and callables with a frame.
#pragma once

#include "framework/frame.hpp"
#include "locked.hpp"
#include "pliant/run/run.hpp"

namespace pliant::python {

/// Summary of a run, and its last state.
struct OwnedRunSummary : RunSummary {
  nb::object state;
  std::vector<Vec3> kept = {};  ///< (F * N) Angstrom; empty where frames were not kept
};

/// Whether the result of a Python observer asks to stop, being true. Needs the GIL.
inline bool is_true(const nb::object& answer) {
  if (answer.is_none()) return false;
  const int truth = PyObject_IsTrue(answer.ptr());
  if (truth < 0) throw nb::python_error();
  return truth == 1;
}

/// Makes an observer of a recorder, which does not need the GIL.
inline Observer recorder_observer(nb::handle object) {
  LockedRecorder& shared = nb::cast<LockedRecorder&>(object);
  return [&shared](const Frame& frame) {
    shared.use([&](H5mdRecorder& recorder) { recorder.record(frame); });
    return false;
  };
}

/// Makes an observer of frames that belong to `state`. Both must outlive it.
inline Observer observer_of(nb::handle object, nb::handle state) {
  if (nb::isinstance<LockedRecorder>(object)) return recorder_observer(object);
  return [object, state](const Frame& frame) {
    const nb::gil_scoped_acquire gil;
    return is_true(object(OwnedFrame{frame, nb::borrow(state)}));
  };
}

}  // namespace pliant::python
