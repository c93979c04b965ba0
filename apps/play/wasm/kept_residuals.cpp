// SPDX-License-Identifier: MIT
#include "kept_residuals.hpp"

#include <cmath>

#include "pliant/framework/measures/residual.hpp"

namespace pliant::play {

KeptResiduals::KeptResiduals(const Framework& framework)
    : framework_(framework), residuals_(framework.bar_count()) {
  groups_.assign(framework.bars());
  worst_.resize(groups_.size());
}

void KeptResiduals::look(std::span<const Vec3> positions) {
  if (!moved_.look(positions)) return;
  groups_.note(moved_);
  groups_.look_at_stale([&](std::size_t group) { measure(positions, group); });
}

void KeptResiduals::measure(std::span<const Vec3> positions, std::size_t group) {
  std::size_t worst = groups_.first(group);
  for (std::size_t k = groups_.first(group); k < groups_.last(group); ++k) {
    const Bar bar = framework_.bars()[k];
    const double rest = framework_.rest_lengths()[k];
    residuals_[k] = static_cast<float>(residual(positions[bar.a], positions[bar.b], rest) / rest);
    if (std::abs(residuals_[k]) > std::abs(residuals_[worst])) worst = k;
  }
  worst_[group] = worst;
}

std::size_t KeptResiduals::worst() const {
  std::size_t worst = 0;
  for (std::size_t bar : worst_)
    if (std::abs(residuals_[bar]) > std::abs(residuals_[worst])) worst = bar;
  return worst;
}

}  // namespace pliant::play
