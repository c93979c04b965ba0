// SPDX-License-Identifier: MIT
#include "pliant/sample/modes_sampler.hpp"

#include <utility>

#include "pliant/sample/amplitudes.hpp"
#include "pliant/sample/network/network_modes.hpp"
#include "pliant/sample/sample_options.hpp"
#include "pliant/sample/samplers.hpp"

namespace pliant {
namespace {

NetworkModes scaled(NetworkModes modes, double amplitude) {
  scale_to(amplitude, modes);
  return modes;
}

}  // namespace

NetworkModes network_modes(const SamplerSetting& setting) {
  return network_modes(setting.nodes, "shared", usual_mode_count,
                       static_cast<std::size_t>(setting.options.threads));
}

ModesSampler::ModesSampler(const SamplerSetting& setting)
    : ModesSampler(setting, network_modes(setting)) {}

ModesSampler::ModesSampler(const SamplerSetting& setting, NetworkModes modes)
    : start_(setting.start),
      moves_(setting.nodes, scaled(std::move(modes), setting.options.amplitude), setting.start),
      seed_(setting.options.seed) {
  const std::int64_t first = setting.options.first_frame;
  const std::int64_t last = first + setting.options.frames - 1;
  first_block_ = first / frames_a_block;
  for (std::int64_t block = first_block_; block <= last / frames_a_block; ++block)
    blocks_.push_back(white_amplitudes(seed_, block, moves_.mode_count()));
}

void ModesSampler::ask(std::int64_t frame, int, int attempt, std::span<const Vec3>,
                       FrameRequest& request) const {
  request.targets.resize(start_.size());
  displace(frame, attempt, request.targets);
  for (std::size_t k = 0; k < start_.size(); ++k) request.targets[k] += start_[k];
  request.limits_off.clear();
  request.course = {};
  request.drawn_by = DrawnBy::modes;
}

void ModesSampler::displace(std::int64_t frame, int attempt, std::span<Vec3> out) const {
  if (attempt > 0)
    return moves_.displacements(redrawn_amplitudes(seed_, frame, attempt, moves_.mode_count()),
                                out);
  const DenseMatrix& block =
      blocks_[static_cast<std::size_t>(frame / frames_a_block - first_block_)];
  moves_.displacements(block.row(static_cast<std::size_t>(frame % frames_a_block)), out);
}

std::unique_ptr<Sampler> make_modes_sampler(const SamplerSetting& setting) {
  return std::make_unique<ModesSampler>(setting);
}

}  // namespace pliant
