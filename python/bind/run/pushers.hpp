// SPDX-License-Identifier: MIT
// Pushers in Python: a Steering, or a callable that moves positions.
#pragma once

#include "bind.hpp"
#include "pliant/perturb/pusher.hpp"

namespace pliant::python {

/// A pusher whose Python object a Motion shows to the garbage collector. Its members need the GIL.
class PusherOfPython : public Pusher {
 public:
  virtual nb::handle object() const = 0;
  virtual void forget_object() = 0;
};

/// A pusher for `state` only. Throws TypeError for anything else.
std::shared_ptr<Pusher> pusher_from(nb::handle object, nb::handle_t<State> state);

void bind_pushers(nb::module_& module);

}  // namespace pliant::python
