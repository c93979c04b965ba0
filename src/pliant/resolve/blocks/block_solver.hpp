// SPDX-License-Identifier: MIT
// Newton's method on the blocks (ring systems) of a framework, one at a time.
#pragma once

#include <optional>
#include <vector>

#include "pliant/resolve/equations/bar_newton.hpp"
#include "pliant/resolve/method/resolve_summary.hpp"
#include "pliant/resolve/method/technique.hpp"

namespace pliant {

/// Positions before and after a push, (N) each.
struct WayOfPush {
  std::span<const Vec3> from, to;
};

class BlockSolver {
 public:
  /// `blocks` has the bars of each block; the framework must outlive it.
  BlockSolver(const Framework& framework, const Technique& technique, const Tolerance& tolerance,
              std::span<const std::vector<BarIndex>> blocks);

  /// False if some block has hubs of so many bars that it is left to sweeps.
  bool holds_all() const { return holds_all_; }
  std::size_t count() const { return parts_.size(); }
  /// Calls `look` with each joint of a block that is solved here.
  template <class Look>
  void each_joint(std::uint32_t block, Look look) const {
    const auto joints = parts_[block]->joints;
    for (std::uint32_t j = joints.begin; j < joints.end; ++j) look(equations_.joint(j));
  }

  /// Some block has so many bars a joint that damping is needed (BarNewton::is_overbraced).
  /// Whether some block has so many bars a joint that damping is needed (BarNewton::is_overbraced).
  bool any_overbraced() const;
  /// The pattern of a block's equations, for loops over its bars.
  BarPattern pattern(std::uint32_t block) const { return equations_.pattern(*parts_[block]); }
  /// The same with `entry` held fixed.
  BarPattern hold(std::uint32_t block, Joint entry) {
    equations_.hold(*parts_[block], entry);
    return pattern(block);
  }

  /// Makes the block whole with `entry` held fixed; random draws depend on `key`. Adds to the
  /// summary's counts. Returns false if the block is left to sweeps or Newton's method stalls, with
  /// the best positions found.
  bool solve(std::uint32_t block, Joint entry, const RandomKey& key, std::span<Vec3> positions,
             ResolveSummary& summary);

  /// Solves a block that could not follow a push: it is carried along with `entry`, and its joints
  /// follow the push by half, a quarter or nothing. The last is whole if the block was whole before
  /// the push. No joint except `entry` may be pinned.
  bool go_part_of_the_way(std::uint32_t block, Joint entry, const RandomKey& key,
                          const WayOfPush& way, std::span<Vec3> positions, ResolveSummary& summary);

 private:
  bool iterate(std::uint32_t block, Joint entry, const RandomKey& key, std::span<Vec3> positions,
               ResolveSummary& summary, std::int64_t most);

  BarEquations equations_;
  std::vector<std::optional<BarEquations::Part>> parts_;
  BarNewton newton_;
  bool holds_all_ = true;
};

}  // namespace pliant
