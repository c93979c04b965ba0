// SPDX-License-Identifier: MIT
// Sampler `pocket`: frames that open or close one place.
#pragma once

#include <cstdint>
#include <vector>

#include "pliant/sample/modes_sampler.hpp"
#include "pliant/sample/pocket/pocket.hpp"
#include "pliant/sample/pocket/pocket_turns.hpp"
#include "pliant/sample/pocket/side_chain_moves.hpp"
#include "pliant/sample/sampler.hpp"

namespace pliant {

/// Side chains of the place are redrawn from rotamers, segments and domains beside it turn, and all
/// goes along a draw of the modes. Contacts that this would tear are let go. Frames are
/// independent; each depends on the seed and its number alone.
class PocketSampler final : public Sampler {
 public:
  explicit PocketSampler(const SamplerSetting& setting);
  PocketSampler(const SamplerSetting& setting, const NetworkModes& modes);

  void ask(std::int64_t frame, int step, int attempt, std::span<const Vec3> now,
           std::span<const Vec3> before, FrameRequest& request) const override;

 private:
  void turn(const DrawnTurns& turned, const std::vector<Vec3>& moves, FrameRequest& request) const;
  void let_go(std::span<const Vec3> without_modes, FrameRequest& request) const;

  const Framework& framework_;
  std::span<const Vec3> start_;
  const NetworkNodes& nodes_;
  std::vector<std::uint32_t> of_joint_;
  Pocket place_;
  PocketTurns turns_;
  SideChainMoves side_chains_;
  ModesSampler modes_;
  std::uint64_t seed_;
};

}  // namespace pliant
