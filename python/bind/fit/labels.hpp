// SPDX-License-Identifier: MIT
#pragma once

#include "bind.hpp"

namespace pliant::python {

void bind_labels(nb::module_& module);

}  // namespace pliant::python
