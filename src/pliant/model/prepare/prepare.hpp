// SPDX-License-Identifier: MIT
// Preparation: from a structure as files have it to one that a model can be built of. What is taken
// out, renamed, added or missing is told line by line.
#pragma once

#include <string>
#include <vector>

#include "pliant/base/log.hpp"
#include "pliant/model/atoms/atom_graph.hpp"
#include "pliant/model/prepare/protonation.hpp"
#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

struct PrepareOptions {
  bool keep_waters = false;
  bool fill_side_chains = false;            ///< their missing atoms by rule: see side_chains.hpp
  bool add_hydrogens = true;                ///< polar hydrogens by rule where there are none
  bool all_hydrogens = false;               ///< those on carbon as well
  std::vector<std::string> protonate = {};  ///< "HIS57:HID", "A:ASP25:ASH"
  /// Models whose B factors are a confidence (pLDDT): contacts of residues below are left out; 0:
  /// of none.
  double floppy_below = 0.0;
  Log log = {};  ///< what is told goes here too: what is missing or guessed as a warning
};

/// A structure made ready, and what was done to it.
struct Preparation {
  Structure structure;
  /// (N) the atom of the structure before that each atom is; no_atom: placed by rule.
  std::vector<std::uint32_t> origin;
  std::vector<std::string> steps;    ///< told line by line, in the order in which it was done
  std::vector<std::string> missing;  ///< what the structure lacks and no rule fills
  std::vector<bool> floppy;          ///< (R) residues whose contacts are left out; empty: none
};

/// Below this a model's residue is likely to have no fixed structure (pLDDT; Tunyasuvunakool et
/// al., Nature 596 (2021) 590).
inline constexpr double disordered_below = 50.0;

/// Makes ready a structure whose bonds are known (perceive_bonds):
/// - waters are taken out, unless they are to be kept;
/// - selenium of MSE (and SEC) becomes the sulphur of MET (CYS), where it is;
/// - ligands and metals stay, with the bonds that the file or distances tell;
/// - side chains are completed by rule, if they are to be;
/// - amino acids get their CB by rule, in a structure that has no side chain at all;
/// - polar hydrogens (on N, O, S) are placed by rule where a residue's part has no hydrogen, with
///   protonation as protonation.hpp says; hydrogens of the structure stay;
/// - hydrogens on carbon are placed by rule where a carbon has none, if all are asked for.
/// Deterministic; linear in the number of atoms.
/// Throws OptionError for a `protonate` that names no residue or no form of it; InputError naming
/// the structure's file if nothing but waters or CA atoms is there.
Preparation prepare(const Structure& structure, const PrepareOptions& options = {});

}  // namespace pliant
