// SPDX-License-Identifier: MIT
// The two ends of a path: which residues and atoms of two structures stand for each other, and
// which contacts both have.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "pliant/model/model.hpp"
#include "pliant/path/path_options.hpp"

namespace pliant {

/// One of the two: a molecule, and which of its atoms are asked to go where the other's are.
struct PathSide {
  MolecularModel model;               ///< with the contacts that both structures have
  std::vector<std::uint32_t> asked;   ///< (K) atoms
  std::vector<std::uint32_t> leader;  ///< (N) the matched residue that each atom goes with: its
                                      ///< own, else the nearest
};

/// The two structures, matched.
struct PathEnds {
  PathSide start;
  std::optional<PathSide> end;            ///< to be moved as well; only where both are
  std::vector<Vec3> goal;                 ///< (K) Angstrom, where the end has the asked atoms
  std::size_t matched = 0;                ///< residues
  std::size_t end_contacts = 0;           ///< contacts that only the end has
  std::vector<MolecularContact> to_lose;  ///< contacts that only the start has
  std::vector<MolecularContact>
      to_make;                     ///< those that only the end has, between atoms of the start
  std::string source_of_end;       ///< its file
  std::vector<std::string> notes;  ///< how residues were matched
};

/// Makes models of both structures (build_model: waters out, polar hydrogens in) and matches them
/// (match_residues). Of each model the contacts that both have are kept. Ligands and metals are
/// matched by chain, number and name; contacts of what is not matched are let go, and counted for
/// neither. Throws OptionError, and InputError where the two are not one molecule or are none of
/// proteins or nucleic acids.
PathEnds match_ends(const Structure& start, const Structure& end, const PathOptions& options = {});

}  // namespace pliant
