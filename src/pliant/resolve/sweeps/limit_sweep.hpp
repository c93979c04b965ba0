// SPDX-License-Identifier: MIT
// The part of a sweep that comes after its bars: limits in their order, then overlaps by joints.
//
// What is outside its interval by more than half the tolerance is projected to there, as a bar of
// that length would be (Gauss-Seidel with inequalities; Jakobsen, GDC 2001); the rest is left
// alone. Bars, held a thousand times closer, need that room to become whole where limits are taut:
// without it sweeps come near ever more slowly. Which pairs
// overlap is decided once, after the limits, so that no skin of the list of pairs and no moment at
// which it was made can show in the result.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "pliant/framework/framework.hpp"
#include "pliant/framework/measures/contacts.hpp"
#include "pliant/framework/measures/residual.hpp"
#include "pliant/resolve/sweeps/sweep_plan.hpp"

namespace pliant {

class LimitSweep {
 public:
  /// The framework must outlive it. Shares are half and half, or by inverse masses.
  LimitSweep(const Framework& framework, bool mass_weighted, const Tolerance& tolerance,
             double skin = 1.0);

  /// Takes the limits that are not `off` from now on.
  void begin(LimitsOff off);

  /// Projects each violated limit, then each pair that overlaps, once. Returns how many limits and
  /// pairs were looked at. Positions that are not finite are left for look() to find.
  std::int64_t sweep(std::span<Vec3> positions, const RandomKey& key);

  /// Is everything within the tolerance?
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
  std::optional<Contacts> contacts_;
  std::vector<Contact> overlaps_;
};

/// What sweeps a framework's limits and sterics; null where it has none.
std::unique_ptr<LimitSweep> make_limit_sweep(const Framework& framework, bool mass_weighted,
                                             const Tolerance& tolerance);

}  // namespace pliant
