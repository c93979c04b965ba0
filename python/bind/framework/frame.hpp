// SPDX-License-Identifier: MIT
// Frame for Python: the library's Frame, whose positions are kept alive by their owner.
#pragma once

#include "bind.hpp"
#include "pliant/framework/frame.hpp"

namespace pliant::python {

/// A frame and the Python object that its positions belong to.
struct OwnedFrame {
  Frame frame;
  nb::object owner;
};

void bind_frame(nb::module_& module);

}  // namespace pliant::python
