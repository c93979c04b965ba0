// SPDX-License-Identifier: MIT
#include "kept_residuals.hpp"

#include <cmath>

#include "pliant/framework/measures/residual.hpp"

namespace pliant::play {

KeptResiduals::KeptResiduals(const Framework& framework)
    : framework_(framework), residuals_(framework.bar_count()) {
  blocks_.assign(framework.bars());
  worst_.resize(blocks_.size());
}

void KeptResiduals::look(std::span<const Vec3> positions) {
  if (!moved_.look(positions)) return;
  blocks_.note(moved_);
  blocks_.look_at_stale([&](std::size_t block) { measure(positions, block); });
}

void KeptResiduals::measure(std::span<const Vec3> positions, std::size_t block) {
  std::size_t worst = blocks_.first(block);
  for (std::size_t k = blocks_.first(block); k < blocks_.last(block); ++k) {
    const Bar bar = framework_.bars()[k];
    const double rest = framework_.rest_lengths()[k];
    residuals_[k] = static_cast<float>(residual(positions[bar.a], positions[bar.b], rest) / rest);
    if (std::abs(residuals_[k]) > std::abs(residuals_[worst])) worst = k;
  }
  worst_[block] = worst;
}

std::size_t KeptResiduals::worst() const {
  std::size_t worst = 0;
  for (std::size_t bar : worst_)
    if (std::abs(residuals_[bar]) > std::abs(residuals_[worst])) worst = bar;
  return worst;
}

}  // namespace pliant::play
