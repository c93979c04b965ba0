// SPDX-License-Identifier: MIT
// The interface of every technique: moves positions until all bars are whole.
#pragma once

#include <span>

#include "pliant/framework/disturbed.hpp"
#include "pliant/resolve/method/resolve_options.hpp"
#include "pliant/resolve/method/resolve_summary.hpp"
#include "pliant/resolve/method/technique.hpp"

namespace pliant {

class JointNeighbours;
class KeptMeasure;
class MovedJoints;

/// One resolve: the positions to move, what was disturbed, and the key of its random draws.
struct ResolveCall {
  std::span<Vec3> positions;             ///< (N) Angstrom
  Disturbed disturbed = {};              ///< orderings begin at its root
  RandomKey key = {};                    ///< seed, walker and step
  std::span<const Vec3> reference = {};  ///< (N) positions before the push, or none
  /// Where joints are noted before they move. None unless the method looks_near() and not all
  /// joints were disturbed.
  MovedJoints* moved = nullptr;
  LimitsOff limits_off = {};          ///< (L) 1: this limit is switched off; empty: all are on
  std::span<const Vec3> pushed = {};  ///< (N) positions as given; empty: `moved` notes them
  /// Measures by the tolerance of the method's options, reusing earlier results. Null if there are
  /// only bars.
  KeptMeasure* measure = nullptr;
  /// With `moved`, and sterics: the joints near each joint.
  JointNeighbours* neighbours = nullptr;
};

class Method {
 public:
  virtual ~Method() = default;

  /// Counts sweeps and projections in `summary` (0 at the start) and returns why it stopped. If a
  /// number is not finite, positions may be anything: the Resolver restores them. With call.moved
  /// it visits only what the disturbed joints reach, or else notes all joints there and visits
  /// every bar.
  virtual Stop resolve(const ResolveCall& call, ResolveSummary& summary) = 0;

  /// Whether it can visit only what few disturbed joints reach.
  virtual bool looks_near() const { return false; }
  /// Makes the plan of such visits, if it has none: its time is not that of a step.
  virtual void prepare_near() {}
};

}  // namespace pliant
