// SPDX-License-Identifier: MIT
// Sampler `reach`: where the molecule is, and where else it could be.
#pragma once

#include <memory>

#include "pliant/sample/modes_sampler.hpp"
#include "pliant/sample/turns_sampler.hpp"

namespace pliant {

/// The first `near_frames` frames are those of `modes`, to the bit. Of each four others one goes
/// along the modes twice as far, two are turns, and one is a turn with a draw of the modes on top.
/// Where no domain can turn, all others go along wide modes.
class ReachSampler final : public Sampler {
 public:
  explicit ReachSampler(const SamplerSetting& setting);
  ReachSampler(const SamplerSetting& setting, const NetworkModes& modes);

  void ask(std::int64_t frame, int step, int attempt, std::span<const Vec3> now,
           std::span<const Vec3> before, FrameRequest& request) const override;

 private:
  void ask_wide(std::int64_t number, int attempt, std::span<const Vec3> now,
                FrameRequest& request) const;

  std::int64_t near_frames_;
  std::size_t joints_;
  TurnsSampler turns_;
  std::unique_ptr<ModesSampler> near_, wide_, on_top_;  ///< null: none of the frames needs it
};

}  // namespace pliant
