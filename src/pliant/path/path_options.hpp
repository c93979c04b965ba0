// SPDX-License-Identifier: MIT
// Options of a path.
#pragma once

#include <cstdint>
#include <functional>
#include <string_view>

#include "pliant/base/log.hpp"

namespace pliant {

/// The atoms that should arrive at the end.
enum class PathAtoms : std::uint8_t {
  alpha,  ///< one for each matched residue: CA, or P in nucleotides
  heavy,  ///< atoms of matched residues with the same name in both structures, except H
};

/// "CA" or "heavy".
std::string_view name(PathAtoms atoms);

/// The atoms of that name. Throws OptionError.
PathAtoms find_path_atoms(std::string_view name);

/// r.m.s. distance at which the end is reached (Angstrom): 0.5 for alpha carbons, 1 for heavy
/// atoms, since bonds and angles of the start keep these further away.
double arrived_within(PathAtoms atoms);

struct PathOptions {
  PathAtoms atoms = PathAtoms::alpha;
  double step = 0.2;           ///< r.m.s. distance of a step (Angstrom), above 0, at most 2
  bool both = false;           ///< both structures first move towards each other
  std::int64_t backtrack = 0;  ///< largest number of detours, 0 to 1000
  std::uint64_t seed = 0;      ///< of the detours
  std::function<bool()> should_stop = {};  ///< called after each sweep; true ends the step
  Log log = {};                            ///< receives messages of preparation
};

/// Throws OptionError naming the option, its range and what was found.
void check(const PathOptions& options);

}  // namespace pliant
