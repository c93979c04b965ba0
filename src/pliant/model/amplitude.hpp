// SPDX-License-Identifier: MIT
// The amplitude of an ensemble (mean r.m.s. fluctuation of residues): a given number, the value
// that B factors imply, or that of another ensemble.
#pragma once

#include <string>
#include <string_view>

#include "pliant/base/log.hpp"
#include "pliant/molecule/structure/structure.hpp"

namespace pliant {

/// An amplitude and its origin.
struct AmplitudeChoice {
  double value = 0.0;  ///< Angstrom
  std::string source;  ///< the number, "bfactors", or the name of a file
  std::string reason;  ///< one line in words: "76 models of x.pdb: mean RMSF of 70 residues"
};

/// Takes a number (Angstrom), the word `bfactors`, or the name of a file with models of a molecule
/// with the same residues. `structure` is what is to be sampled. Throws OptionError for a number
/// that is not above 0, for `plddt`, which is a confidence and not a distance, for B factors
/// without information, and for a word that is no file; InputError and FileError as
/// ensemble_amplitude() does.
AmplitudeChoice choose_amplitude(std::string_view text, const Structure& structure, const Log& log);

/// Mean over residues (or other atoms, if there are none) of sqrt(3 B / (8 pi^2)), with B of the
/// alpha carbon or of P or C4' (B. T. M. Willis, A. W. Pryor, Thermal Vibrations in Crystallography
/// (1975): B = 8 pi^2 <u^2> / 3). Warns that B factors contain more than motion of the molecule.
/// Throws OptionError if there are no B factors, all are equal or 0, or they look like pLDDT.
AmplitudeChoice b_factor_amplitude(const Structure& structure, const Log& log);

}  // namespace pliant
