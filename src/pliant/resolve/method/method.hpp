// SPDX-License-Identifier: MIT
// What every technique is made of on the inside: moves positions until all bars are whole.
#pragma once

#include <span>

#include "pliant/framework/disturbed.hpp"
#include "pliant/resolve/method/resolve_options.hpp"
#include "pliant/resolve/method/resolve_summary.hpp"
#include "pliant/resolve/method/technique.hpp"

namespace pliant {

class KeptMeasure;
class MovedJoints;

/// One resolve: the positions to move, what was disturbed, and the key of its random draws.
struct ResolveCall {
  std::span<Vec3> positions;             ///< (N) Angstrom
  Disturbed disturbed = {};              ///< its root is where orderings begin
  RandomKey key = {};                    ///< seed, walker and step
  std::span<const Vec3> reference = {};  ///< (N) positions before the push, or none
  /// Where to note joints before they move. None unless not all joints were disturbed and the
  /// method looks_near().
  MovedJoints* moved = nullptr;
  LimitsOff limits_off = {};          ///< (L) 1: this limit is switched off; empty: none is
  std::span<const Vec3> pushed = {};  ///< (N) positions as they came; empty: `moved` notes them
  /// Measures by the tolerance of the method's options, and remembers from call to call. Null:
  /// there are bars alone.
  KeptMeasure* measure = nullptr;
};

class Method {
 public:
  virtual ~Method() = default;

  /// Counts sweeps and projections in `summary` (0 at the start) and tells why it stopped. May
  /// leave anything where it stopped at a number that is not finite: the Resolver puts it back.
  /// With call.moved it looks at what the disturbed joints reach and no further, or else notes all
  /// joints there and looks at every bar.
  virtual Stop resolve(const ResolveCall& call, ResolveSummary& summary) = 0;

  /// Whether it knows how to look only at what few disturbed joints reach.
  virtual bool looks_near() const { return false; }
};

}  // namespace pliant
