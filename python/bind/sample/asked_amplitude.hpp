// SPDX-License-Identifier: MIT
// The amplitude as a Python argument: a number, B factors, or an ensemble in a file.
#pragma once

#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/variant.h>

#include <filesystem>
#include <string>
#include <variant>

#include "pliant/base/number.hpp"
#include "pliant/base/system/path_text.hpp"

namespace pliant::python {

/// Angstrom, `bfactors`, or a file.
using AskedAmplitude = std::variant<double, std::filesystem::path>;

/// The text for asked_amplitude() of the library.
inline std::string amplitude_text(const AskedAmplitude& asked) {
  const double* value = std::get_if<double>(&asked);
  return value ? shortest_text(*value) : path_text(std::get<std::filesystem::path>(asked));
}

}  // namespace pliant::python
