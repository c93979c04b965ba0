// SPDX-License-Identifier: MIT
// Force files: pushes to be replayed, one a step, with the settings that they were made for. The
// format is described in data/README.md.
//
//   pliant-forces 1
//   timestep 0.01            # ps
//   tolerance_length 0.001   # Angstrom; or "tolerance 1e-6", relative
//   max_sweeps 1000
//   push C1 12.5 -3 0.25     # joint, force (x, y, z) in kJ/(mol Angstrom)
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pliant/base/error.hpp"
#include "pliant/perturb/perturbation.hpp"

namespace pliant {

/// What a force file holds. Settings that it leaves out must come from somewhere else.
struct ForceFile {
  std::optional<double> timestep;          ///< ps
  std::optional<double> tolerance;         ///< relative
  std::optional<double> tolerance_length;  ///< Angstrom
  std::optional<std::int64_t> max_sweeps;
  std::vector<JointForce> pushes;  ///< one a step
};

/// The joint that a force file means by `word`: the one whose name is `word`, else, if `word` is a
/// number, the joint of that index, from 0. Throws InputError at `place` if there is none or if
/// several joints have the name.
Joint joint_named(const Framework& framework, std::string_view word, const Place& place);

/// Throws InputError naming file, line and what was expected; FileError if it cannot be read.
ForceFile read_force_file(const std::filesystem::path& path, const Framework& framework);
ForceFile parse_force_file(std::string_view text, std::string_view file_name,
                           const Framework& framework);

/// The text that parse_force_file reads back to the same bits. Throws InputError if a joint has no
/// name of its own and its index is the name of another one.
std::string write_force_file(const ForceFile& forces, const Framework& framework);

}  // namespace pliant
