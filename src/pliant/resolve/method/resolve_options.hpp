// SPDX-License-Identifier: MIT
// Options of a resolve: tolerance, limit of sweeps, seed.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "pliant/framework/measures/residual.hpp"

namespace pliant {

/// A bar that a sweep has just repaired.
struct RepairedBar {
  BarIndex bar = 0;
  Joint near = 0, far = 0;          ///< as in the ordering that is swept
  std::span<const Vec3> positions;  ///< (N) Angstrom, now; valid during the call only
};

/// Options of a resolve. Checked once, when a Resolver is made.
struct ResolveOptions {
  Tolerance tolerance = {};                ///< when a bar counts as whole
  std::int64_t max_sweeps = 10000;         ///< give up after this many sweeps; from 1
  std::uint64_t seed = 0;                  ///< for random orderings and coincident joints
  std::uint64_t walker = 0;                ///< which of several independent runs this is
  std::function<bool()> should_stop = {};  ///< called after each sweep; true ends the resolve
  /// Called after each visit to a bar, for a person who watches. Only techniques that are orderings
  /// support it; the others refuse it. Walkers are then not resolved in lanes. Changes no result.
  std::function<void(const RepairedBar&)> on_bar = {};
};

/// Throws OptionError "max_sweeps = 0: must be from 1" and the like.
void check(const ResolveOptions& options);

}  // namespace pliant
