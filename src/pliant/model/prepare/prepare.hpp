// SPDX-License-Identifier: MIT
// Preparation: makes a structure from a file ready for a model. Each removal, renaming, addition or
// gap is reported.
#pragma once

#include <string>
#include <vector>

#include "pliant/base/log.hpp"
#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

struct PrepareOptions {
  bool keep_waters = false;
  /// Residue names of additives of crystallisation to keep (crystal_additives()), or "all".
  std::vector<std::string> keep = {};
  bool fill_side_chains = false;            ///< complete side chains by rule: see side_chains.hpp
  bool add_hydrogens = true;                ///< polar hydrogens by rule, where there are none
  bool all_hydrogens = false;               ///< hydrogens on carbon, too
  std::vector<std::string> protonate = {};  ///< "HIS57:HID", "A:ASP25:ASH"
  /// For models whose B factors are a confidence (pLDDT): leave out contacts of residues below this
  /// value; 0: of none.
  double floppy_below = 0.0;
  Log log = {};  ///< also receives the notes; what is missing or guessed is a warning
};

/// A prepared structure, and what was done to it.
struct Preparation {
  Structure structure;
  /// (N) index of each atom before preparation; no_atom: placed by rule.
  std::vector<std::uint32_t> origin;
  std::vector<std::string> steps;    ///< what was done, one sentence each, in order
  std::vector<std::string> missing;  ///< what the structure lacks and no rule adds
  std::vector<std::string>
      left_out;              ///< "188 waters", "3 molecules of crystallisation: 3 GOL (...)"
  std::vector<bool> floppy;  ///< (R) residues whose contacts are left out; empty: none
};

/// A residue with less pLDDT is likely to have no fixed structure (Tunyasuvunakool et al., Nature
/// 596 (2021) 590).
inline constexpr double disordered_below = 50.0;

/// Prepares a structure whose bonds are known (perceive_bonds):
/// - waters are removed, unless they are to be kept;
/// - so are additives of crystallisation, where there is a protein or nucleic acid, unless they are
///   bonded to something else, hold a metal, or are to be kept (additives.hpp);
/// - selenium of MSE (and SEC) becomes the sulphur of MET (CYS), at the same position;
/// - ligands and metals are kept, with the bonds from the file or by distance;
/// - side chains are completed by rule, if asked for;
/// - amino acids get their CB by rule, in a structure without any side chain;
/// - polar hydrogens (on N, O, S) are placed by rule where a residue's part has no hydrogen, with
///   protonation according to protonation.hpp; existing hydrogens are kept;
/// - hydrogens on carbon are placed by rule where a carbon has none, if asked for.
/// Deterministic; linear in the number of atoms. Throws OptionError for a `keep` that names no
/// additive and a `protonate` that names no residue or no form of it; InputError naming the
/// structure's file if it has nothing but waters or CA atoms.
Preparation prepare(const Structure& structure, const PrepareOptions& options = {});

}  // namespace pliant
