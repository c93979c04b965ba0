// SPDX-License-Identifier: MIT
// How the library speaks to Python: warnings become Python warnings of the class PliantWarning,
// notes go to the logger "pliant". Both may be called without the GIL.
#pragma once

#include "bind.hpp"
#include "pliant/base/log.hpp"

namespace pliant::python {

/// A log whose warnings point `stacklevel` Python frames up: 1 is the caller of the extension.
Log python_log(int stacklevel = 1);

}  // namespace pliant::python
