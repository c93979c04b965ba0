// SPDX-License-Identifier: MIT
#include "pliant/fit/fit_nodes.hpp"

#include <algorithm>

#include "pliant/base/math/lbfgs.hpp"

namespace pliant {
namespace {

// More is lost in the choice of a start than these leave.
constexpr MinimiseOptions until{.steps = 120, .memory = 10, .tolerance = 1e-2, .least_gain = 1e-6};
constexpr int rounds = 2;       // of a stage: sterics are looked up anew before each
constexpr int last_rounds = 4;  // of the last one

double sum_of(std::span<FitTerm* const> terms, std::span<const Vec3> nodes,
              std::span<Vec3> gradient) {
  std::ranges::fill(gradient, Vec3());
  double value = 0.0;
  for (const FitTerm* term : terms) value += term->add(nodes, gradient);
  return value;
}

}  // namespace

FittedNodes fit_nodes(const FitNodes& start, std::span<FitTerm* const> data, std::size_t stages) {
  SpringTerm springs(start);
  StericTerm sterics(start);
  std::vector<FitTerm*> all{&springs, &sterics};
  all.insert(all.end(), data.begin(), data.end());
  FittedNodes found{.positions = start.positions};
  const ValueAndGradient energy = [&](std::span<const Vec3> x, std::span<Vec3> gradient) {
    return sum_of(all, x, gradient);
  };
  for (std::size_t stage = 0; stage < stages; ++stage) {
    const int count = stage + 1 < stages ? rounds : last_rounds;
    for (int round = 0; round < count; ++round) {
      for (FitTerm* term : all) term->begin(stage, found.positions);
      found.has_converged = minimise(energy, found.positions, until).has_converged;
    }
  }
  std::vector<Vec3> unused(found.positions.size());
  const std::span<FitTerm* const> terms(all);
  found.strain = sum_of(terms.first(2), found.positions, unused);
  found.misfit = sum_of(terms.subspan(2), found.positions, unused);
  return found;
}

}  // namespace pliant
