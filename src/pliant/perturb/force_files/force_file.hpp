// SPDX-License-Identifier: MIT
// Force files: pushes to be replayed, one a step, with the settings that they were made for. Files
// with several forces a step are written as events (force_events.hpp).
//
//   pliant-forces 3              # then the header, see force_header.hpp
//   set timestep 0.01            # ps
//   set tolerance_length 0.001   # Angstrom; or "set tolerance 1e-6", relative
//   set max_sweeps 1000
//   push C1 12.5 -3 0.25         # joint, force (x, y, z) in kJ/(mol Angstrom)
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pliant/framework/measures/residual.hpp"
#include "pliant/perturb/force_files/force_events.hpp"
#include "pliant/perturb/force_files/force_header.hpp"
#include "pliant/perturb/perturbation.hpp"

namespace pliant {

/// The contents of a force file. JointNames says how it refers to joints.
struct ForceFile {
  std::optional<double> timestep;          ///< ps
  std::optional<double> tolerance;         ///< relative
  std::optional<double> tolerance_length;  ///< Angstrom
  std::optional<std::int64_t> max_sweeps;
  std::vector<JointForce> pushes;  ///< one a step
  /// (S) number of pushes in each step, to be written as events
  std::vector<std::int64_t> counts = {};
  /// Other options of a run; checked when they are used.
  std::vector<ForceSetting> settings = {};
  ForceHeader header = {};

  /// Sets timestep, tolerance (the one that is in use) and max_sweeps.
  void set(const PerturbOptions& options, Tolerance within, std::int64_t most_sweeps);
};

/// Reads a force file. Throws InputError naming file, line and what was expected, also where the
/// file was made for another number of joints or bars; FileError if it cannot be read.
ForceFile read_force_file(const std::filesystem::path& path, const Framework& framework);
/// Parses a force file without checking that its header fits the framework.
ForceFile parse_force_file(std::string_view text, std::string_view file_name,
                           const Framework& framework);

/// The settings of a file as events: timestep, tolerance and max_sweeps first.
std::vector<ForceEvent> settings_of(const ForceFile& forces);

/// Makes a force file of random_pushes() with the settings that they are meant for.
ForceFile make_force_file(const Framework& framework, const PerturbOptions& options,
                          Tolerance tolerance, std::int64_t max_sweeps, const RandomKey& key,
                          std::int64_t count);

/// Returns text that parse_force_file, or parse_force_events if there are counts, reads back to the
/// same bits. Throws InputError as JointNames::word_for.
std::string write_force_file(const ForceFile& forces, const Framework& framework);

}  // namespace pliant
