// SPDX-License-Identifier: MIT
// The library's messages in Python: warnings become Python warnings of the class PliantWarning,
// notes go to the logger "pliant". Both may be called without the GIL.
#pragma once

#include "bind.hpp"
#include "pliant/base/log.hpp"

namespace pliant::python {

/// A log whose warnings refer to the caller's line outside of the package.
Log python_log();

/// The same for use in destructors: where warnings are errors, they are printed.
Log unraisable_python_log();

}  // namespace pliant::python
