// SPDX-License-Identifier: MIT
// What crystals are grown from, frozen and handled with: solvents, precipitants, buffers and the
// like, which a structure holds where the crystal did, not where a cell does.
#pragma once

#include <span>
#include <string_view>
#include <vector>

namespace pliant {

/// One row of the table of additives.
struct CrystalAdditive {
  std::string_view residues;  ///< names in the Chemical Component Dictionary: "ACT ACY"
  std::string_view chemical;  ///< "acetate"
};

/// All rows. The names are a part of those that BioLiP takes for artefacts until other evidence is
/// there (J. Yang et al., Nucleic Acids Res. 41 (2013) D1096) or that AlphaFold 3 leaves out
/// (J. Abramson et al., Nature 630 (2024) 493, supplementary tables 9 and 10): without ions of one
/// atom, and without sugars, lipids, cofactors, metabolites and inhibitors, which those lists have.
std::span<const CrystalAdditive> crystal_additives();

/// The names of all rows.
std::vector<std::string_view> crystal_additive_names();

}  // namespace pliant
