// SPDX-License-Identifier: MIT
// A planned sweep: bars in the order of their visits, each with all data for the kernel.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "pliant/framework/framework.hpp"
#include "pliant/framework/measures/residual.hpp"
#include "pliant/resolve/method/resolve_options.hpp"
#include "pliant/resolve/method/technique.hpp"

namespace pliant {

/// A visit with all data for the kernel side by side in memory.
struct PlannedBar {
  Joint near, far;  ///< indices into the positions that are swept
  double rest, near_share, far_share;
  double allowed;  ///< largest |length - rest| that counts as whole
  BarIndex bar;
  bool planar;  ///< coincident joints separate in the plane
};

/// `visit` with its shares and tolerance.
PlannedBar planned(const Framework& framework, const Technique& technique,
                   const Tolerance& tolerance, const OrderedBar& visit);

enum class Look { all_whole, broken, not_finite };

class SweepPlan {
 public:
  void clear() { visits_.clear(); }
  void add(const PlannedBar& visit) { visits_.push_back(visit); }
  std::size_t size() const { return visits_.size(); }

  /// Projects each bar once. `key` gives the directions in which coincident joints separate.
  void sweep(std::span<Vec3> positions, const RandomKey& key, bool backwards = false) const;

  /// The same, and calls a function after each visit.
  void sweep_watched(std::span<Vec3> positions, const RandomKey& key, bool backwards,
                     const std::function<void(const RepairedBar&)>& on_bar) const;

  /// Returns whether every bar is whole. Begins where the last call found a broken bar, so that it
  /// costs next to nothing while much is broken.
  Look look(std::span<const Vec3> positions);
  /// Forgets where the last look() ended, so that a resolve does not depend on earlier ones.
  void begin() { hint_ = 0; }

 private:
  Look look_at(std::span<const Vec3> positions, std::size_t from, std::size_t to);

  std::vector<PlannedBar> visits_;
  std::size_t hint_ = 0;
};

}  // namespace pliant
