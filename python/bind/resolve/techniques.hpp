// SPDX-License-Identifier: MIT
// Techniques in Python: a name, or a callable that makes a sweep.
#pragma once

#include <memory>

#include "bind.hpp"
#include "pliant/resolve/method/technique.hpp"

namespace pliant {
class Framework;
}

namespace pliant::python {

/// A name in techniques(), or a callable with arguments (positions, sweep, framework).
struct TechniqueLike {
  nb::object object;
};

/// Sets name and sweep. Throws TypeError for anything else.
void choose(Technique& technique, const TechniqueLike& chosen);

/// Sets the framework that sweeps in Python receive, before they are called; it must outlive them.
void show_framework(Technique& technique, const Framework& framework);

/// The callable of a sweep in Python, for the garbage collector. Needs the GIL.
class CallableOf {
 public:
  CallableOf() = default;
  explicit CallableOf(const Technique& technique);
  int traverse(visitproc visit, void* argument) const;
  void clear();

 private:
  std::shared_ptr<nb::object> callable_;  ///< null: none
};

}  // namespace pliant::python

namespace nanobind::detail {

/// Accepts any object and leaves the checks to choose(), whose message can say more.
template <>
struct type_caster<pliant::python::TechniqueLike> {
  NB_TYPE_CASTER(pliant::python::TechniqueLike,
                 const_name("str | collections.abc.Callable[[numpy.typing.NDArray[numpy.float64], "
                            "int, Framework], None]"))
  bool from_python(handle source, uint32_t, cleanup_list*) noexcept {
    value.object = borrow(source);
    return true;
  }
};

}  // namespace nanobind::detail
