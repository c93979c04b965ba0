// SPDX-License-Identifier: MIT
// Chooses a few conformers of many: those of lowest energy that differ in shape.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "pliant/sample/choice/shape_distances.hpp"

namespace pliant {

struct ConformerChoice {
  std::size_t most = 50;
  double rms = 0.5;      ///< Angstrom: conformers no further apart are alike
  double window = 1e300;  ///< kcal/mol above the lowest energy at most
};

/// Numbers of the chosen conformers, by energy, lowest first: each that is not alike one before it.
/// Ties go to the first. `energies` (conformers), kcal/mol. Throws OptionError for a number below
/// one, a negative distance or window; InputError where energies are not finite or not as many.
std::vector<std::size_t> choose_conformers(const ShapeDistances& shapes,
                                           std::span<const double> energies,
                                           const ConformerChoice& choice);

}  // namespace pliant
