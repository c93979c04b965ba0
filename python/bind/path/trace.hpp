// SPDX-License-Identifier: MIT
// Traces of residues, their sequences, and the matching of two structures.
#pragma once

#include "bind.hpp"

namespace pliant::python {

void bind_trace(nb::module_& module);

}  // namespace pliant::python
