// SPDX-License-Identifier: MIT
// Sampler `modes`: independent frames along the modes of an elastic network.
#pragma once

#include <vector>

#include "pliant/base/math/dense_matrix.hpp"
#include "pliant/sample/network/mode_displacement.hpp"
#include "pliant/sample/sampler.hpp"

namespace pliant {

/// Modes of the nodes, found on as many threads as the options say.
NetworkModes network_modes(const SamplerSetting& setting);

class ModesSampler : public Sampler {
 public:
  explicit ModesSampler(const SamplerSetting& setting);
  /// With modes of the nodes that are found already, whatever their scale.
  ModesSampler(const SamplerSetting& setting, NetworkModes modes);

  void ask(std::int64_t frame, int step, int attempt, std::span<const Vec3> now,
           FrameRequest& request) const override;

  /// (N, Angstrom) How far the modes move each joint in a frame. `frame` must be one of those of
  /// the options.
  void displace(std::int64_t frame, int attempt, std::span<Vec3> out) const;

 private:
  std::span<const Vec3> start_;
  ModeDisplacement moves_;
  std::uint64_t seed_;
  std::int64_t first_block_ = 0;
  std::vector<DenseMatrix> blocks_;
};

}  // namespace pliant
