// SPDX-License-Identifier: MIT
#include "pliant/resolve/sweeps/sweep_plan.hpp"

#include <cmath>

#include "pliant/resolve/method/project_bar.hpp"
#include "pliant/resolve/method/shares.hpp"

namespace pliant {
namespace {

/// Within each loop that calls it: a call costs a tenth of a sweep.
[[gnu::always_inline]] inline void project(std::span<Vec3> positions, const PlannedBar& visit,
                                           const RandomKey& key) {
  project_bar(positions[visit.near], positions[visit.far], visit.rest, visit.near_share,
              visit.far_share, [&] { return escape_direction(key, visit.bar, visit.planar); });
}

}  // namespace

PlannedBar planned(const Framework& framework, const Technique& technique,
                   const Tolerance& tolerance, const OrderedBar& visit) {
  const Bar bar = framework.bars()[visit.bar];
  const double rest = framework.rest_lengths()[visit.bar];
  const auto [near_share, far_share] = shares(technique, visit, framework);
  const Joint far = visit.near == bar.a ? bar.b : bar.a;
  return {visit.near,           far, rest, near_share, far_share, tolerance.of(rest), visit.bar,
          framework.is_planar()};
}

void SweepPlan::sweep(std::span<Vec3> positions, const RandomKey& key, bool backwards) const {
  if (backwards) {
    for (auto visit = visits_.rbegin(); visit != visits_.rend(); ++visit)
      project(positions, *visit, key);
  } else {
    for (const PlannedBar& visit : visits_) project(positions, visit, key);
  }
}

void SweepPlan::sweep_watched(std::span<Vec3> positions, const RandomKey& key, bool backwards,
                              const std::function<void(const RepairedBar&)>& on_bar) const {
  for (std::size_t k = 0; k < visits_.size(); ++k) {
    const PlannedBar& visit = visits_[backwards ? visits_.size() - 1 - k : k];
    project(positions, visit, key);
    on_bar({visit.bar, visit.near, visit.far, positions});
  }
}

Look SweepPlan::look(std::span<const Vec3> positions) {
  if (hint_ >= visits_.size()) hint_ = 0;
  const Look tail = look_at(positions, hint_, visits_.size());
  return tail == Look::all_whole ? look_at(positions, 0, hint_) : tail;
}

Look SweepPlan::look_at(std::span<const Vec3> positions, std::size_t from, std::size_t to) {
  for (std::size_t k = from; k < to; ++k) {
    const PlannedBar& visit = visits_[k];
    const double error =
        std::abs(residual(positions[visit.near], positions[visit.far], visit.rest));
    if (error <= visit.allowed) continue;
    hint_ = k;
    return std::isfinite(error) ? Look::broken : Look::not_finite;
  }
  return Look::all_whole;
}

}  // namespace pliant
