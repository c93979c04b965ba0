// SPDX-License-Identifier: MIT
// Newton's method on the blocks (ring systems) of a framework, one at a time.
#pragma once

#include <optional>
#include <vector>

#include "pliant/resolve/direct/bar_newton.hpp"
#include "pliant/resolve/method/resolve_summary.hpp"
#include "pliant/resolve/method/technique.hpp"

namespace pliant {

/// Where a push began and where it led, (N) each.
struct WayOfPush {
  std::span<const Vec3> from, to;
};

class BlockSolver {
 public:
  /// `blocks` are the bars of each; the framework must outlive it.
  BlockSolver(const Framework& framework, const Technique& technique, const Tolerance& tolerance,
              std::span<const std::vector<BarIndex>> blocks);

  /// False if a block is so entangled (hubs of many bars) that it is left to sweeps.
  bool holds_all() const { return holds_all_; }
  std::size_t count() const { return parts_.size(); }
  /// Calls `look` with each joint of a block that is held.
  template <class Look>
  void each_joint(std::uint32_t block, Look look) const {
    const auto joints = parts_[block]->joints;
    for (std::uint32_t j = joints.begin; j < joints.end; ++j) look(equations_.joint(j));
  }

  /// Some block has so many bars a joint that damping is needed (BarNewton::is_overbraced).
  bool any_overbraced() const;
  /// What the loops over a block look at.
  BarPattern pattern(std::uint32_t block) const { return equations_.pattern(*parts_[block]); }
  /// The same with `entry` held still.
  BarPattern hold(std::uint32_t block, Joint entry) {
    equations_.hold(*parts_[block], entry);
    return pattern(block);
  }

  /// Makes the block whole with `entry` held still, random draws depending on `key`, adding to the
  /// summary's counts. False if it is not held or Newton's method stalled: positions are then as
  /// good as they got.
  bool solve(std::uint32_t block, Joint entry, const RandomKey& key, std::span<Vec3> positions,
             ResolveSummary& summary);

  /// The same for a block that could not follow a push: carried along with `entry`, it follows half
  /// of it, a quarter, or none, which is whole if the block was whole before the push. None of its
  /// joints but `entry` may be pinned.
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
