// SPDX-License-Identifier: MIT
// The part of a sweep that follows the bars: limits in their order, then overlaps by joints.
//
// A limit that is outside its interval by more than half the tolerance is projected to that
// distance, as a bar of that length (Gauss-Seidel with inequalities; Jakobsen, GDC 2001); others
// are left alone. Bars, whose tolerance is a thousand times smaller, need that room to become whole
// where limits are taut: without it sweeps converge ever more slowly. The overlapping pairs are
// determined once, after the limits, so that neither the skin of the list of pairs nor the time at
// which it was made affects the result.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "pliant/framework/framework.hpp"
#include "pliant/framework/measures/neighbour_list.hpp"
#include "pliant/framework/measures/residual.hpp"
#include "pliant/resolve/sweeps/sweep_plan.hpp"

namespace pliant {

class LimitSweep {
 public:
  /// The framework must outlive it. Shares are equal, or by inverse masses.
  LimitSweep(const Framework& framework, bool mass_weighted, const Tolerance& tolerance,
             double skin = 1.0);

  /// From now on considers only limits that are not `off`.
  void begin(LimitsOff off);

  /// Projects each violated limit, then each pair that overlaps, once. Returns the number of limits
  /// and pairs visited. Does nothing about positions that are not finite, which look() finds.
  std::int64_t sweep(std::span<Vec3> positions, const RandomKey& key);

  /// Returns whether everything is within the tolerance.
  Look look(std::span<const Vec3> positions);

 private:
  struct PlannedLimit {
    Limit limit;
    double share_a, share_b;
    LimitIndex index;
  };

  Look look_at_limits(std::span<const Vec3> positions) const;
  Look look_at_contacts(std::span<const Vec3> positions);
  void project(std::span<Vec3> positions, const PlannedLimit& planned, const RandomKey& key) const;
  void part_overlaps(std::span<Vec3> positions, const RandomKey& key);

  const Framework& framework_;
  bool mass_weighted_;
  Tolerance tolerance_;
  std::vector<PlannedLimit> limits_;
  std::optional<NeighbourList> contacts_;
  std::vector<NeighbourPair> overlaps_;
};

/// Makes the sweep of a framework's limits and sterics; null if it has none.
std::unique_ptr<LimitSweep> make_limit_sweep(const Framework& framework, bool mass_weighted,
                                             const Tolerance& tolerance);

}  // namespace pliant
