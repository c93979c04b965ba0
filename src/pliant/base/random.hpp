// SPDX-License-Identifier: MIT
// Counter-based random numbers: each draw is a pure function of where it is used, never of what was
// drawn before, so that threads, shards and techniques all meet the same pushes.
// Generator: Philox4x64-10 (Salmon, Moraes, Dror, Shaw, "Parallel random numbers: as easy as 1, 2,
// 3", SC11).
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "pliant/base/vec3.hpp"

namespace pliant {

/// What a random number is for; keeps the draws of one seed apart.
enum class Domain : std::uint64_t {
  root_joint = 1,    ///< which joint is pushed
  force = 2,         ///< direction of a force
  displacement = 3,  ///< direction of a displacement
  order = 4,         ///< shuffles and random roots
  escape = 5,        ///< direction in which coincident joints part
  generate = 6,      ///< random frameworks
  pusher = 7,        ///< seeds of the pushers after the first
  amplitude = 8,     ///< how far a sampled frame goes along each mode
  dilution = 9,      ///< which limits are off in a sampled frame
  walk = 10,         ///< steps of a sampler that walks
  torsion = 11,      ///< torsions, rings and flexible loops of a sampled conformer
  turn = 12,         ///< which domains of a sampled frame turn, and how
  pocket = 13,       ///< side chains and segments of a place in a sampled frame
  start = 14,        ///< how rings of a further start of conformers are shaken
  region = 15,       ///< whether a push that a region cannot follow is tried in a larger one
  loop = 16,         ///< loops of proteins that are redrawn in a sampled frame
};

/// Where a random number is used: all of its fields together make the draw.
struct RandomKey {
  std::uint64_t seed = 0;
  Domain domain = Domain::root_joint;
  std::uint64_t walker = 0;
  std::uint64_t step = 0;
  std::uint64_t joint = 0;
};

/// 256 random bits: Philox4x64-10 of a counter and a key.
std::array<std::uint64_t, 4> philox4x64(std::array<std::uint64_t, 4> counter,
                                        std::array<std::uint64_t, 2> key);

/// An endless sequence of draws that belongs to one key; cheap to make.
class RandomSequence {
 public:
  explicit RandomSequence(const RandomKey& key) : key_(key) {}
  /// A sequence whose first 256 bits, philox4x64 of the key, have been drawn already.
  RandomSequence(const RandomKey& key, const std::array<std::uint64_t, 4>& first)
      : key_(key), block_(first), has_first_(true) {}

  std::uint64_t bits();  ///< 64 uniform bits
  double uniform();      ///< uniform in [0, 1), a multiple of 2^-53
  /// Uniform in [0, bound), without bias (Lemire 2019); bound > 0.
  std::uint64_t below(std::uint64_t bound);
  /// Uniform on the unit sphere (Marsaglia 1972: rejection, then one square root; no trigonometry,
  /// whose last bits differ between C libraries).
  Vec3 direction();
  /// Uniform on the unit circle in the plane z = 0, by the same method.
  Vec3 direction_in_plane();

 private:
  RandomKey key_;
  std::array<std::uint64_t, 4> block_{};
  std::uint64_t drawn_ = 0;
  bool has_first_ = false;
};

/// out[i] = RandomSequence(key with joint key.joint + i).direction(), or direction_in_plane(). The
/// numbers are those drawn one by one, in half the time: generators of several joints run side by
/// side.
void random_directions(RandomKey key, bool planar, std::span<Vec3> out);

}  // namespace pliant
