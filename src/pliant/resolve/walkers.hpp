// SPDX-License-Identifier: MIT
// Resolving many walkers (independent copies of one framework) at once: eight in SIMD lanes.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

#include "pliant/resolve/method/walker_positions.hpp"
#include "pliant/resolve/resolve.hpp"

namespace pliant {

/// How walkers are resolved; no choice changes any result.
struct LaneOptions {
  bool lanes = true;            ///< false: one walker after the other
  std::string_view level = {};  ///< a name in lane_level_names(); the best one if empty
};

/// Instructions that this build and this processor have for lanes, the best ones first: "v4"
/// (x86-64-v4, AVX-512), "v3" (AVX2), "v2" (SSE4.2), "portable".
std::span<const std::string_view> lane_level_names();

/// Resolves groups of eight walkers in SIMD lanes where the technique has a way to (sweeps of one
/// ordering for all, `blocks`, `newton`, `shake`), others one after the other. Each walker ends
/// with the same bits as alone in a Resolver, whoever stands beside it. Not for two threads at
/// once.
class WalkerResolver {
 public:
  /// As Resolver; options.walker is not looked at. Throws OptionError, also for an unknown level.
  WalkerResolver(const Framework& framework, const Technique& technique,
                 const ResolveOptions& options = {}, const LaneOptions& lanes = {});
  ~WalkerResolver();
  WalkerResolver(WalkerResolver&&) noexcept;

  /// Whether walkers are resolved in lanes, and how: "v4", ..., or "" if one after the other.
  std::string_view level();

  /// What resolves walkers one after the other; set_walker() first.
  Resolver& alone();

  /// Moves the positions of all walkers as Resolver::resolve moves one's; they share root and step.
  /// `summaries` has one of each walker; their seconds are a walker's share of its group's. Asked
  /// to stop, walkers that are not begun stay where they are: their sweeps are -1. Throws
  /// OptionError as Resolver::resolve.
  void resolve(std::span<const WalkerPositions> walkers, std::span<ResolveSummary> summaries,
               Joint root = 0, std::int64_t step = 0, Measured measured = Measured::max_residual);

 private:
  struct Plan;
  std::unique_ptr<Plan> plan_;
};

}  // namespace pliant
