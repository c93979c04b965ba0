// SPDX-License-Identifier: MIT
// Chooses a few conformers of many: those of low energy that differ in shape. As energies are not
// exact, a conformer unlike those chosen before may have a higher one (maximal marginal relevance:
// J. Carbonell, J. Goldstein, SIGIR (1998) 335).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "pliant/conformers/choice/shape_distances.hpp"

namespace pliant {

struct ConformerChoice {
  std::size_t most = 50;
  double rms = 0.3;       ///< Angstrom: conformers no further apart are alike
  double window = 1e300;  ///< kcal/mol above the lowest energy at most
};

/// Numbers of the chosen conformers, by energy, lowest first, which is always among them. Each next
/// one has the least energy less 8 kcal/mol times the logarithm of its distance from the nearest
/// chosen, up to 2 Angstrom: the most of exp(-energy / 8) times distance.
/// Ties go to the first. `energies` (conformers), kcal/mol. Throws OptionError for a number below
/// one, a negative distance or window; InputError where energies are not finite or not as many.
std::vector<std::size_t> choose_conformers(const ShapeDistances& shapes,
                                           std::span<const double> energies,
                                           const ConformerChoice& choice);

}  // namespace pliant
