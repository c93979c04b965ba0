// SPDX-License-Identifier: MIT
// One of several walkers that are resolved at once, and which residuals are measured at the end.
#pragma once

#include <cstdint>
#include <span>

#include "pliant/base/vec3.hpp"
#include "pliant/framework/limits.hpp"

namespace pliant {

/// One walker of a call.
struct WalkerPositions {
  std::uint64_t walker = 0;              ///< its number, on which its random draws depend
  std::span<Vec3> positions;             ///< (N) Angstrom, are moved
  std::span<const Vec3> reference = {};  ///< as in Resolver::resolve
  LimitsOff limits_off = {};             ///< as in Resolver::set_limits_off
};

/// Which residuals the summaries of walkers contain. All bars are checked in any case.
enum class Measured {
  nothing,       ///< max_residual and rms_residual are -1
  max_residual,  ///< rms_residual is -1
  rms_residual,  ///< both
};

}  // namespace pliant
