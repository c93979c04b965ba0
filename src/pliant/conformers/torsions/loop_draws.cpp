// SPDX-License-Identifier: MIT
#include "pliant/conformers/torsions/loop_draws.hpp"

#include <cmath>

#include "pliant/conformers/torsions/loop_closing.hpp"

namespace pliant {
namespace {

/// The least strained of so many draws is taken; draws end where hydrogen bonds outweigh strain.
constexpr int draws_a_loop = 4;
/// While none is found, there are up to so many, amides drawn anew for each `draws_a_loop`.
constexpr int most_draws = 40;
/// Some frames are made wide, others compact: atoms of loops are asked to be up to so many times as
/// far apart as they must be.
constexpr double largest_reach = 1.5;
/// Sine of a torsion (13 degrees): amides that are twisted further are taken only if those of the
/// start are, and no draw had planar ones; then the least twisted.
constexpr double most_twisted = 0.23, twisted = 1e6;

}  // namespace

void LoopDraws::draw(RandomSequence& draws, TorsionDraw how, std::span<Vec3> x) const {
  const double reach = 1.0 + (largest_reach - 1.0) * draws.uniform();
  LoopClosing start(plan_, loops_, x, reach);
  const bool must_be_flat = start.twist() < most_twisted;
  double least = HUGE_VAL;
  for (int k = 0; k < most_draws && (k < draws_a_loop || least >= twisted) && least > 0.0; ++k) {
    if (k % draws_a_loop == 0) start.draw_amides(draws);
    LoopClosing trial = start;
    trial.open(draws, how);
    trial.relax(how);
    if (!trial.close()) continue;
    const double twist = trial.twist();
    const bool is_flat = twist < most_twisted;
    if (must_be_flat && !is_flat) continue;
    const double here = trial.strain(how) + (is_flat ? 0.0 : twisted * (1.0 + twist));
    if (!(here < least)) continue;
    least = here;
    trial.write(x);
  }
}

}  // namespace pliant
