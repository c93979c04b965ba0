// SPDX-License-Identifier: MIT
// Options of a path.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pliant/base/option_fields.hpp"
#include "pliant/model/model.hpp"

namespace pliant {

/// Which atoms are asked to arrive.
struct PathAtoms {
  std::string_view name;
  bool are_heavy;  ///< all but H; else one of each residue
  /// r.m.s. distance at which the end is reached (Angstrom): bonds and angles of the start keep
  /// heavy atoms further off.
  double arrived_within;
};

/// "CA", one of each matched residue (P of nucleotides), and "heavy", those of matched residues
/// that have the same name in both structures, but no H.
std::span<const PathAtoms> path_atoms();

/// The row of that name. Throws OptionError listing the known names.
const PathAtoms& find_path_atoms(std::string_view name);

struct PathOptions {
  std::string atoms = "CA";    ///< a name in path_atoms()
  double step = 0.2;           ///< r.m.s. distance of a step (Angstrom), above 0, at most 2
  bool both = false;           ///< both structures first move towards each other
  std::int64_t backtrack = 0;  ///< largest number of detours, 0 to 1000
  std::uint64_t seed = 0;      ///< of the detours
  /// How both ends are prepared, and what holds them. Contacts that are given and `floppy_below`
  /// are of the start alone; torsions are never preferred.
  ModelOptions model = {};
  std::function<bool()> should_stop = {};  ///< called after each sweep; true ends the step
};

/// The table from which the command's options, Python's keywords, the page's settings, what files
/// keep and check() come, in the order in which help lists them.
std::span<const OptionField<PathOptions>> path_fields();

/// Options by their paths below /parameters: "path/step".
std::vector<NamedParameter> parameters_of(const PathOptions& options);

/// Throws OptionError naming the option, its value and its range.
void check(const PathOptions& options);

}  // namespace pliant
