// SPDX-License-Identifier: MIT
// What Python asks of an amplitude: a number, B factors, or an ensemble in a file.
#pragma once

#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/variant.h>

#include <filesystem>
#include <string>
#include <variant>

#include "pliant/base/number.hpp"

namespace pliant::python {

/// Angstrom, `bfactors`, or a file.
using AskedAmplitude = std::variant<double, std::filesystem::path>;

/// The text that asked_amplitude() of the library takes.
inline std::string amplitude_text(const AskedAmplitude& asked) {
  const double* value = std::get_if<double>(&asked);
  return value ? shortest_text(*value) : std::get<std::filesystem::path>(asked).string();
}

}  // namespace pliant::python
