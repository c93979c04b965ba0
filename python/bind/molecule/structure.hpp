// SPDX-License-Identifier: MIT
// The class Structure: its columns as arrays, and its construction from arrays.
#pragma once

#include "bind.hpp"
#include "pliant/molecule/structure/structure.hpp"

namespace pliant::python {

nb::class_<Structure> bind_structure(nb::module_& module);

}  // namespace pliant::python
