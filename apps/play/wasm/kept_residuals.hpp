// SPDX-License-Identifier: MIT
// The residual of each bar, as the page shows it; each step costs only as much as what moved.
#pragma once

#include <span>
#include <vector>

#include "pliant/framework/framework.hpp"
#include "pliant/framework/measures/moved_pairs.hpp"

namespace pliant::play {

class KeptResiduals {
 public:
  /// The framework must outlive it.
  explicit KeptResiduals(const Framework& framework);

  /// Updates the residuals for these positions (N).
  void look(std::span<const Vec3> positions);

  /// (M) signed (length - rest) / rest of each bar at the last update.
  std::span<const float> all() const { return residuals_; }
  /// The bar with the largest residual; 0 if there is none.
  std::size_t worst() const;

 private:
  void measure(std::span<const Vec3> positions, std::size_t group);

  const Framework& framework_;
  MovedPositions moved_;
  MovedPairs groups_;
  std::vector<float> residuals_;
  std::vector<std::size_t> worst_;  ///< of each group
};

}  // namespace pliant::play
