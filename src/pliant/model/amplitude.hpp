// SPDX-License-Identifier: MIT
// How far frames of an ensemble are to go: as given, as far as B factors say, or as far as another
// ensemble goes. An amplitude is the mean r.m.s. fluctuation of residues.
#pragma once

#include <string>
#include <string_view>

#include "pliant/base/log.hpp"
#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

/// An amplitude and where it is from.
struct AmplitudeChoice {
  double value = 0.0;  ///< Angstrom
  std::string source;  ///< the number, "bfactors", or the name of a file
  std::string reason;  ///< in words, one line: "76 models of x.pdb: mean RMSF of 70 residues"
};

/// From a number (Angstrom), the word `bfactors`, or the name of a file with models of a molecule
/// of the same residues. `structure` is what is to be sampled. Throws OptionError for a number that
/// is not above 0, for `plddt`, which is a confidence and no distance, for B factors that tell
/// nothing, and for a word that is no file; InputError and FileError as ensemble_amplitude() does.
AmplitudeChoice choose_amplitude(std::string_view text, const Structure& structure, const Log& log);

/// Mean over residues (other atoms, where there are none) of sqrt(3 B / (8 pi^2)), B that of the
/// alpha carbon or of P or C4' (B. T. M. Willis, A. W. Pryor, Thermal Vibrations in Crystallography
/// (1975): B = 8 pi^2 <u^2> / 3). Warns that B factors hold more than motion of the molecule.
/// Throws OptionError where there are no B factors, all are equal or 0, or they look like pLDDT.
AmplitudeChoice b_factor_amplitude(const Structure& structure, const Log& log);

}  // namespace pliant
