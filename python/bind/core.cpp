// SPDX-License-Identifier: MIT
// The extension module pliant._core: calls one add function for each folder of the library.
#include <nanobind/nanobind.h>

#include "pliant/base/version.hpp"

namespace nb = nanobind;

NB_MODULE(_core, module) {
  module.doc() = "Compiled part of Pliant; use the names that the package pliant gives.";
  module.attr("__version__") = nb::str(pliant::version().data(), pliant::version().size());
}
