// SPDX-License-Identifier: MIT
// Sampler `reach`: where the molecule is, and where else it could be.
#include <algorithm>
#include <utility>

#include "pliant/sample/modes_sampler.hpp"
#include "pliant/sample/network/network_modes.hpp"
#include "pliant/sample/sample_options.hpp"
#include "pliant/sample/samplers.hpp"
#include "pliant/sample/turns_sampler.hpp"

namespace pliant {
namespace {

constexpr double wide = 2.0;         // of the amplitude
constexpr std::int64_t a_round = 4;  // frames: one of wide modes, three turns
/// The seed of wide modes: near frames have the seed itself.
constexpr std::uint64_t wide_seed = 1;

/// Modes of frames [first, first + frames), so far; null for none.
std::unique_ptr<ModesSampler> modes_of(const SamplerSetting& setting, const NetworkModes& modes,
                                       std::int64_t first, std::int64_t frames, double amplitude,
                                       std::uint64_t seed) {
  if (frames < 1) return nullptr;
  SampleOptions options = setting.options;
  options.first_frame = first;
  options.frames = frames;
  options.amplitude = std::min(amplitude * options.amplitude, largest_amplitude);
  options.seed += seed * 0x9e3779b97f4a7c15u;  // far from seeds that users count up
  return std::make_unique<ModesSampler>(
      SamplerSetting{setting.framework, setting.plan, setting.start, setting.nodes, options},
      modes);
}

/// The first `near_frames` frames are those of `modes`, to the bit. Of each four others one goes
/// along the modes twice as far, and three are turns. Where no domain can turn, all others go along
/// wide modes.
class ReachSampler final : public Sampler {
 public:
  explicit ReachSampler(const SamplerSetting& setting);
  ReachSampler(const SamplerSetting& setting, const NetworkModes& modes);

  void ask(std::int64_t frame, int step, int attempt, std::span<const Vec3> now,
           FrameRequest& request) const override;

 private:
  void ask_wide(std::int64_t number, int attempt, std::span<const Vec3> now,
                FrameRequest& request) const;

  std::int64_t near_frames_;
  TurnsSampler turns_;
  std::unique_ptr<ModesSampler> near_, wide_;  ///< null: none of the frames needs it
};

ReachSampler::ReachSampler(const SamplerSetting& setting)
    : ReachSampler(setting, network_modes(setting)) {}

ReachSampler::ReachSampler(const SamplerSetting& setting, const NetworkModes& modes)
    : near_frames_(setting.options.near_frames), turns_(setting, modes) {
  const std::int64_t first = setting.options.first_frame;
  const std::int64_t end = first + setting.options.frames;
  near_ = modes_of(setting, modes, first, std::min(end, near_frames_) - first, 1.0, 0);
  // Numbers of others go on from those of near frames.
  const std::int64_t other = std::max(first, near_frames_) - near_frames_;
  const std::int64_t others = end - near_frames_ - other;
  wide_ = modes_of(setting, modes, other, others, wide, wide_seed);
}

void ReachSampler::ask(std::int64_t frame, int step, int attempt, std::span<const Vec3> now,
                       FrameRequest& request) const {
  if (frame < near_frames_) return near_->ask(frame, step, attempt, now, request);
  const std::int64_t number = frame - near_frames_;
  if (turns_.empty() || number % a_round == 0) return ask_wide(number, attempt, now, request);
  turns_.ask(number, step, attempt, now, request);
}

void ReachSampler::ask_wide(std::int64_t number, int attempt, std::span<const Vec3> now,
                            FrameRequest& request) const {
  wide_->ask(number, 0, attempt, now, request);
  request.drawn_by = DrawnBy::wide_modes;
}

}  // namespace

std::unique_ptr<Sampler> make_reach_sampler(const SamplerSetting& setting) {
  return std::make_unique<ReachSampler>(setting);
}

}  // namespace pliant
