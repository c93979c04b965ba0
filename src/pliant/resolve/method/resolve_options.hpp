// SPDX-License-Identifier: MIT
// How hard a resolve tries: tolerance, limit of sweeps, seed.
#pragma once

#include <cstdint>
#include <functional>

#include "pliant/framework/residual.hpp"

namespace pliant {

/// How hard to try. Checked once, when a Resolver is made.
struct ResolveOptions {
  Tolerance tolerance = {};                ///< when a bar counts as whole
  std::int64_t max_sweeps = 10000;         ///< give up after this many sweeps; from 1
  std::uint64_t seed = 0;                  ///< for random orderings and coincident joints
  std::uint64_t walker = 0;                ///< which of several independent runs this is
  std::function<bool()> should_stop = {};  ///< asked after each sweep; true ends the resolve
};

/// Throws OptionError "max_sweeps = 0: must be from 1" and the like.
void check(const ResolveOptions& options);

}  // namespace pliant
