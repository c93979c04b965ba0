// SPDX-License-Identifier: MIT
#include "pliant/conformers/torsions/loop_draws.hpp"

#include <cmath>

#include "pliant/conformers/torsions/loop_closing.hpp"

namespace pliant {
namespace {

/// The least strained of so many draws is taken; draws end where hydrogen bonds outweigh strain.
constexpr int draws_a_loop = 8;
/// Some frames are made wide, others compact: atoms of loops are asked to be up to so many times as
/// far apart as they must be.
constexpr double largest_reach = 1.5;

}  // namespace

void LoopDraws::draw(RandomSequence& draws, TorsionDraw how, std::span<Vec3> x) const {
  const double reach = 1.0 + (largest_reach - 1.0) * draws.uniform();
  const LoopClosing start(plan_, loops_, x, reach);
  double least = HUGE_VAL;
  for (int k = 0; k < draws_a_loop && least > 0.0; ++k) {
    LoopClosing trial = start;
    trial.open(draws, how);
    trial.relax(how);
    if (!trial.close()) continue;
    const double here = trial.strain(how);
    if (!(here < least)) continue;
    least = here;
    trial.write(x);
  }
}

}  // namespace pliant
