// SPDX-License-Identifier: MIT
// Fits the nodes of a molecule to data: the shape of the start gives way where the data ask for it.
#pragma once

#include <span>
#include <vector>

#include "pliant/fit/fit_term.hpp"
#include "pliant/fit/shape_terms.hpp"

namespace pliant {

struct FittedNodes {
  std::vector<Vec3> positions;  ///< (M) Angstrom
  double strain = 0.0;          ///< energy of springs and sterics
  double misfit = 0.0;          ///< energy of the data in the last stage
  bool has_converged = false;
};

/// Minimises springs, sterics and `data` from the start, stage by stage, up to the stage before
/// `stages`: with fewer, data count less. Takes time in proportion
/// to the number of nodes.
FittedNodes fit_nodes(const FitNodes& start, std::span<FitTerm* const> data,
                      std::size_t stages = std::size(fit_weights));

}  // namespace pliant
