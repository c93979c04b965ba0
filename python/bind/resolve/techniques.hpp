// SPDX-License-Identifier: MIT
// Techniques as Python gives them: a name, or whatever can be called to make a sweep.
#pragma once

#include <memory>

#include "bind.hpp"
#include "pliant/resolve/method/technique.hpp"

namespace pliant {
class Framework;
}

namespace pliant::python {

/// A name in techniques(), or something to be called with (positions, sweep, framework).
struct TechniqueLike {
  nb::object object;
};

/// Sets name and sweep. Throws TypeError for what is neither a name nor to be called.
void choose(Technique& technique, const TechniqueLike& chosen);

/// What sweeps in Python are shown; it must outlive them. To be said before they are called.
void show_framework(Technique& technique, const Framework& framework);

/// What sweeps are made of in Python, for the garbage collector. Needs the GIL.
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

/// Takes any object and leaves the checking to choose(), whose message can say more.
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
