// SPDX-License-Identifier: MIT
// In the place of bind_generate.cpp, bind_laboratory.cpp and bind_test_parts.cpp, where the
// laboratory is left out of a build: pliant/_laboratory.py says so.
#include "bind.hpp"

namespace pliant::python {

void bind_generate(nb::module_&) {}
void bind_laboratory(nb::module_&) {}

}  // namespace pliant::python
