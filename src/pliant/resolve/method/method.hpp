// SPDX-License-Identifier: MIT
// What every technique is made of on the inside: moves positions until all bars are whole.
#pragma once

#include <span>

#include "pliant/resolve/method/resolve_options.hpp"
#include "pliant/resolve/method/resolve_summary.hpp"
#include "pliant/resolve/method/technique.hpp"

namespace pliant {

/// One resolve: the positions to move, the pushed joint, and the key of its random draws.
struct ResolveCall {
  std::span<Vec3> positions;  ///< (N) Angstrom
  Joint root = 0;
  RandomKey key = {};                    ///< seed, walker and step
  std::span<const Vec3> reference = {};  ///< (N) positions before the push, or none
  LimitsOff limits_off = {};             ///< (L) limits that are switched off, or none
};

class MovedJoints;

class Method {
 public:
  virtual ~Method() = default;
  /// Counts sweeps and projections in `summary` (0 at the start) and tells why it stopped. May
  /// leave positions that are not finite: the caller puts them back.
  virtual Stop resolve(const ResolveCall& call, ResolveSummary& summary) = 0;

  /// The same where every bar away from the root is whole: looks only at what the push disturbs.
  /// Sets summary.stop and gives the joints that moved, or null (and does nothing) if this method
  /// knows no such way.
  virtual const MovedJoints* resolve_near(const ResolveCall&, ResolveSummary&) { return nullptr; }
};

}  // namespace pliant
