// SPDX-License-Identifier: MIT
// How the library speaks to Python: warnings become Python warnings of the class PliantWarning,
// notes go to the logger "pliant". Both may be called without the GIL.
#pragma once

#include "bind.hpp"
#include "pliant/base/log.hpp"

namespace pliant::python {

/// A log whose warnings point to the line of the caller that is outside of the package.
Log python_log();

/// The same for what may speak in a destructor: where warnings are errors, they are printed.
Log unraisable_python_log();

}  // namespace pliant::python
