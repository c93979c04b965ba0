// SPDX-License-Identifier: MIT
// The two ends of a path: matched residues and atoms of two structures, and the contacts that both
// have.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "pliant/model/model.hpp"
#include "pliant/path/path_options.hpp"

namespace pliant {

/// One end: a molecule, and the atoms that are to reach the other end.
struct PathSide {
  MolecularModel model;              ///< with the contacts that both structures have
  std::vector<std::uint32_t> asked;  ///< (K) atoms
  /// (N) the matched residue with which each atom moves: its own, else the nearest
  std::vector<std::uint32_t> leader;
};

/// The two structures, matched.
struct PathEnds {
  PathSide start;
  std::optional<PathSide> end;            ///< set only if both ends move
  std::vector<Vec3> goal;                 ///< (K) Angstrom, positions of the asked atoms at the end
  std::size_t matched = 0;                ///< number of residues
  std::size_t end_contacts = 0;           ///< number of contacts that only the end has
  std::vector<MolecularContact> to_lose;  ///< contacts that only the start has
  std::vector<MolecularContact>
      to_make;                     ///< contacts that only the end has, between atoms of the start
  std::string source_of_end;       ///< its file
  std::vector<std::string> notes;  ///< how residues were matched
};

/// Builds models of both structures (build_model, by PathOptions::model) and matches them
/// (match_residues). Each model keeps the contacts that both have. Ligands and metals are
/// matched by chain, number and name; contacts of unmatched residues are dropped, and do not count.
/// Throws OptionError, and InputError if the two are not the same molecule or have neither proteins
/// nor nucleic acids.
PathEnds match_ends(const Structure& start, const Structure& end, const PathOptions& options = {});

/// Ends whose goal is not a structure, but the places of some atoms of the start's model: `goal`
/// (K, Angstrom) of `atoms` (K, one of each residue, rising; three or more). Contacts are held
/// unless the goal changes the distance of their residues by more than 2 Angstrom; those are
/// to_lose. The walk begins `from` another frame of the model (N), or where the start is. Throws
/// OptionError, and InputError for atoms that do not exist or goals that are not finite.
PathEnds ends_at(const Structure& start, std::vector<std::uint32_t> atoms, std::vector<Vec3> goal,
                 const PathOptions& options = {}, std::vector<Vec3> from = {});

/// The model of a start, as ends have it, with all contacts that are found.
MolecularModel model_of_start(const Structure& structure, ModelOptions options);

}  // namespace pliant
