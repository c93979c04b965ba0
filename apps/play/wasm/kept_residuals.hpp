// SPDX-License-Identifier: MIT
// By how much each bar misses its rest length, as a page shows it; step by step, at a cost of what
// moved.
#pragma once

#include <span>
#include <vector>

#include "pliant/framework/framework.hpp"
#include "pliant/framework/measures/moved_blocks.hpp"

namespace pliant::play {

class KeptResiduals {
 public:
  /// The framework outlives it.
  explicit KeptResiduals(const Framework& framework);

  /// Looks at these positions (N).
  void look(std::span<const Vec3> positions);

  /// Of the last look: signed (length - rest) / rest of each bar (M).
  std::span<const float> all() const { return residuals_; }
  /// The bar that misses it most; 0 where there is none.
  std::size_t worst() const;

 private:
  void measure(std::span<const Vec3> positions, std::size_t block);

  const Framework& framework_;
  MovedChunks moved_;
  PairBlocks blocks_;
  std::vector<float> residuals_;
  std::vector<std::size_t> worst_;  ///< of each block
};

}  // namespace pliant::play
