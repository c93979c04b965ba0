// SPDX-License-Identifier: MIT
// Pushers from Python: a Steering, or whatever can be called with positions to move.
#pragma once

#include "bind.hpp"
#include "pliant/perturb/pusher.hpp"

namespace pliant::python {

/// A pusher whose Python object a Motion tells the garbage collector of. Its members need the GIL.
class PusherOfPython : public Pusher {
 public:
  virtual nb::handle object() const = 0;
  virtual void forget_object() = 0;
};

/// A pusher that acts on `state` and on no other. Throws TypeError for what is none.
std::shared_ptr<Pusher> pusher_from(nb::handle object, nb::handle_t<State> state);

void bind_pushers(nb::module_& module);

}  // namespace pliant::python
