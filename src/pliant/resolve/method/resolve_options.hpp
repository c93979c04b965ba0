// SPDX-License-Identifier: MIT
// How hard a resolve tries: tolerance, limit of sweeps, seed.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "pliant/framework/measures/residual.hpp"

namespace pliant {

/// A bar that a sweep has just repaired.
struct RepairedBar {
  BarIndex bar = 0;
  Joint near = 0, far = 0;          ///< in the ordering that is swept
  std::span<const Vec3> positions;  ///< (N) Angstrom, now; valid during the call only
};

/// How hard to try. Checked once, when a Resolver is made.
struct ResolveOptions {
  Tolerance tolerance = {};                ///< when a bar counts as whole
  std::int64_t max_sweeps = 10000;         ///< give up after this many sweeps; from 1
  std::uint64_t seed = 0;                  ///< for random orderings and coincident joints
  std::uint64_t walker = 0;                ///< which of several independent runs this is
  std::function<bool()> should_stop = {};  ///< asked after each sweep; true ends the resolve
  /// For a person who wants to watch: shown each visit to a bar. Techniques that are orderings know
  /// how, the others refuse it; walkers are then not resolved in lanes. Changes no result.
  std::function<void(const RepairedBar&)> on_bar = {};
};

/// Throws OptionError "max_sweeps = 0: must be from 1" and the like.
void check(const ResolveOptions& options);

}  // namespace pliant
