// SPDX-License-Identifier: MIT
// What is asked of conformers of small molecules. Energies and what RDKit does are chosen by the
// package in Python.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "pliant/base/log.hpp"
#include "pliant/base/option_fields.hpp"
#include "pliant/text/file_text.hpp"

namespace pliant {

struct ConformerOptions {
  std::int64_t max = 50;    ///< conformers of a molecule
  std::int64_t frames = 0;  ///< candidates, shared among the starts; 0: as settle() has them
  std::int64_t starts = 5;  ///< structures with other lengths and angles to draw from
  double rms = 0.3;         ///< Angstrom, heavy atoms; nearer ones are left out; 0: none
  double window = 0.0;      ///< kcal/mol above the lowest energy; 0: all are kept
  std::string energy = "auto";
  bool minimise = false;    ///< by the energy
  bool embed = false;       ///< what is not 3-D, or has no hydrogens, is made so
  bool amides = false;      ///< secondary amides are cis or trans, too
  bool both_hands = false;  ///< of axes: nobody gave one; no option of users
  std::int64_t seed = 0;
  std::string smiles = {};  ///< bond orders, charges and hydrogens of a ligand; "": not given
  std::int64_t max_input = usual_text / 1'000'000;  ///< MB, of a library once it is decompressed
  std::int64_t threads = 1;                         ///< changes no result
  Log log = {};
};

/// The table of these options; "conformers" of a job.
std::span<const OptionField<ConformerOptions>> conformer_fields();

/// Throws OptionError for an option out of range.
void check(const ConformerOptions& options);

/// Sets how many candidates are drawn, if that is open. Throws as check() does.
void settle(ConformerOptions& options);

}  // namespace pliant
