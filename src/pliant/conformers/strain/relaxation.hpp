// SPDX-License-Identifier: MIT
// Relaxes positions into the nearest minimum of an energy, by L-BFGS (J. Nocedal, Math. Comput. 35
// (1980) 773).
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "pliant/base/vec3.hpp"

namespace pliant {

/// An energy (kcal/mol) of positions; writes its gradient.
using EnergyOf = std::function<double(std::span<const Vec3> x, std::span<Vec3> gradient)>;

struct RelaxationOptions {
  int steps = 200;
  double least_gradient = 0.05;  ///< r.m.s., kcal/mol/Angstrom: ends there
  double longest_move = 0.2;     ///< Angstrom, of an atom in a step
};

/// Moves `x` (N, Angstrom) downhill; returns the energy there. Never goes uphill.
double relax(const EnergyOf& energy, const RelaxationOptions& options, std::vector<Vec3>& x);

}  // namespace pliant
