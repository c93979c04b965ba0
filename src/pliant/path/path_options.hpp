// SPDX-License-Identifier: MIT
// What a path is asked for.
#pragma once

#include <cstdint>
#include <functional>
#include <string_view>

#include "pliant/base/log.hpp"

namespace pliant {

/// Which atoms are asked to arrive.
enum class PathAtoms : std::uint8_t {
  alpha,  ///< one of each matched residue: CA, P of nucleotides
  heavy,  ///< those of matched residues that have the same name in both structures, but no H
};

/// "CA" or "heavy".
std::string_view name(PathAtoms atoms);

/// The atoms of that name. Throws OptionError.
PathAtoms find_path_atoms(std::string_view name);

/// r.m.s. distance at which the end is reached (Angstrom): 0.5 of alpha carbons, 1 of heavy atoms,
/// which bonds and angles of the start keep further off.
double arrived_within(PathAtoms atoms);

struct PathOptions {
  PathAtoms atoms = PathAtoms::alpha;
  double step = 0.2;           ///< r.m.s. distance of a step (Angstrom), above 0, at most 2
  bool both = false;           ///< both structures go towards each other first
  std::int64_t backtrack = 0;  ///< how often to go back and try a detour, 0 to 1000
  std::uint64_t seed = 0;      ///< of the detours
  std::function<bool()> should_stop = {};  ///< asked after each sweep; true ends the step
  Log log = {};                            ///< of how the two molecules are prepared
};

/// Throws OptionError naming the option, its range and what was found.
void check(const PathOptions& options);

}  // namespace pliant
