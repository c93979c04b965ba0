// SPDX-License-Identifier: MIT
// Shows the garbage collector the Python objects that C++ objects hold: a function given to an
// object often refers to that object.
#pragma once

#include "bind.hpp"

namespace pliant::python {

/// Type slots for a class with `int traverse(visitproc, void*) const` and `void clear()`.
template <class Type>
struct Collected {
  static int traverse(PyObject* self, visitproc visit, void* argument) {
    if (const int answer = visit(reinterpret_cast<PyObject*>(Py_TYPE(self)), argument))
      return answer;
    return nb::inst_ready(self) ? nb::inst_ptr<Type>(self)->traverse(visit, argument) : 0;
  }

  static int clear(PyObject* self) {
    nb::inst_ptr<Type>(self)->clear();
    return 0;
  }

  static inline PyType_Slot slots[] = {{Py_tp_traverse, reinterpret_cast<void*>(&traverse)},
                                       {Py_tp_clear, reinterpret_cast<void*>(&clear)},
                                       {0, nullptr}};
};

}  // namespace pliant::python
