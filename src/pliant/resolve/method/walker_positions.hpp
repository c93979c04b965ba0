// SPDX-License-Identifier: MIT
// One of several walkers that are resolved at once, and what is asked about where they end.
#pragma once

#include <cstdint>
#include <span>

#include "pliant/base/vec3.hpp"
#include "pliant/framework/limits.hpp"

namespace pliant {

/// One walker of a call.
struct WalkerPositions {
  std::uint64_t walker = 0;              ///< its number: what its random draws depend on
  std::span<Vec3> positions;             ///< (N) Angstrom, to be moved
  std::span<const Vec3> reference = {};  ///< as of Resolver::resolve
  LimitsOff limits_off = {};             ///< as of Resolver::set_limits_off
};

/// What the summaries of walkers tell of their residuals. All bars are looked at in any case.
enum class Measured {
  nothing,       ///< max_residual and rms_residual are -1
  max_residual,  ///< rms_residual is -1
  rms_residual,  ///< both
};

}  // namespace pliant
