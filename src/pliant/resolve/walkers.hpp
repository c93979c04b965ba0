// SPDX-License-Identifier: MIT
// Resolving many walkers (independent copies of one framework) at once: eight in SIMD lanes.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

#include "pliant/resolve/method/lane_options.hpp"
#include "pliant/resolve/method/walker_positions.hpp"
#include "pliant/resolve/resolve.hpp"

namespace pliant {

/// Instructions that this build and this processor have for lanes, the best ones first: "v4"
/// (x86-64-v4, AVX-512), "v3" (AVX2), "v2" (SSE4.2), "portable".
std::span<const std::string_view> lane_level_names();

/// Resolves groups of eight walkers in SIMD lanes if the technique supports that (sweeps of one
/// ordering for all, `blocks`, `newton`, `shake`), others one after another. Each walker ends with
/// the same bits as alone in a Resolver, whatever its neighbours. Not thread-safe.
class WalkerResolver {
 public:
  /// As Resolver; options.walker is ignored. Throws OptionError, also for an unknown level.
  WalkerResolver(const Framework& framework, const Technique& technique,
                 const ResolveOptions& options = {}, const LaneOptions& lanes = {});
  ~WalkerResolver();
  WalkerResolver(WalkerResolver&&) noexcept;

  /// Whether lanes may be used: for bars alone, by a technique that has lanes. Unlike level() it
  /// makes no plan.
  bool may_use_lanes() const;
  /// The level of the lanes: "v4", ..., or "" if walkers are resolved one after another.
  std::string_view level();

  /// The resolver for walkers one after another; call set_walker() first.
  Resolver& alone();

  /// Moves the positions of all walkers as Resolver::resolve does for one; they share root and
  /// step. `summaries` has one entry for each walker; its seconds are the walker's share of its
  /// group's. If asked to stop, walkers that have not begun do not move, and their sweeps are -1.
  /// Throws OptionError as Resolver::resolve.
  void resolve(std::span<const WalkerPositions> walkers, std::span<ResolveSummary> summaries,
               Joint root = 0, std::int64_t step = 0, Measured measured = Measured::max_residual);

 private:
  struct LanePlan;
  std::unique_ptr<LanePlan> plan_;
};

}  // namespace pliant
