// SPDX-License-Identifier: MIT
// Rigidity of what is a graph and no molecule.
#pragma once

#include "bind.hpp"

namespace pliant::python {

/// Whether an argument is a Graph, a Framework or the path of a graph XML file.
bool is_graph(nb::handle argument);

/// Adds the overload of `rigidity` for these, after that for molecules, which leaves them to it.
void bind_framework_rigidity(nb::module_& module);

}  // namespace pliant::python
