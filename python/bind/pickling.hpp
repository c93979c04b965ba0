// SPDX-License-Identifier: MIT
// Pickling of Framework, Structure and State, which sends them to worker processes. All numbers
// keep their bits.
#pragma once

#include "bind.hpp"
#include "pliant/framework/framework.hpp"
#include "pliant/molecule/structure/structure.hpp"

namespace pliant::python {

/// Each adds __getstate__ and __setstate__. Other states raise ValueError.
void bind_pickling(nb::class_<Framework>& framework);
void bind_pickling(nb::class_<Structure>& structure);
void bind_pickling(nb::class_<State>& state);

}  // namespace pliant::python
