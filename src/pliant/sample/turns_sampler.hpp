// SPDX-License-Identifier: MIT
// Sampler `turns`: domains turned as wholes about the links that join them.
#pragma once

#include <cstdint>
#include <vector>

#include "pliant/sample/network/network_modes.hpp"
#include "pliant/sample/sampler.hpp"
#include "pliant/sample/turns/turn_draws.hpp"

namespace pliant {

/// Each frame depends on the seed and its number alone.
class TurnsSampler final : public Sampler {
 public:
  /// Its frames are asked for unless it is empty().
  TurnsSampler(const SamplerSetting& setting, const NetworkModes& modes);

  bool has_amplitude() const override { return false; }

  /// Whether there are domains that can turn.
  bool empty() const { return draws_.empty(); }

  void ask(std::int64_t frame, int step, int attempt, std::span<const Vec3> now,
           FrameRequest& request) const override;

 private:
  const Framework& framework_;
  std::span<const Vec3> start_;
  const NetworkNodes& nodes_;
  TurnDraws draws_;
  std::vector<std::uint32_t> of_joint_;
  std::uint64_t seed_;
};

}  // namespace pliant
