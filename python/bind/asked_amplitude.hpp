// SPDX-License-Identifier: MIT
// What Python asks of an amplitude: a number, B factors, or an ensemble in a file.
#pragma once

#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/variant.h>

#include <filesystem>
#include <variant>

#include "messages.hpp"
#include "pliant/base/number.hpp"
#include "pliant/model/amplitude.hpp"
#include "pliant/model/ensemble_amplitude.hpp"
#include "pliant/record/h5md/h5md_reader.hpp"

namespace pliant::python {

/// Angstrom, `bfactors`, or a file.
using AskedAmplitude = std::variant<double, std::filesystem::path>;

inline AmplitudeChoice amplitude_of(const AskedAmplitude& asked, const Structure& structure) {
  if (const double* value = std::get_if<double>(&asked))
    return choose_amplitude(shortest_text(*value), structure, python_log());
  const std::filesystem::path& path = std::get<std::filesystem::path>(asked);
  if (path.extension() == ".h5md" || path.extension() == ".h5")
    return trajectory_amplitude(H5mdReader(path, {"", python_log()}), path.string(), structure,
                                python_log());
  return choose_amplitude(path.string(), structure, python_log());
}

}  // namespace pliant::python
