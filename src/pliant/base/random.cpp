// SPDX-License-Identifier: MIT
#include "pliant/base/random.hpp"

#include <cmath>

#include "pliant/base/wide_product.hpp"

namespace pliant {
namespace {

using Counter = std::array<std::uint64_t, 4>;
using Key = std::array<std::uint64_t, 2>;

/// `count` generators side by side: each waits for its own multiplications, not for the others'.
template <std::size_t count>
void philox_all(std::array<Counter, count>& counters, Key key) {
  constexpr int rounds = 10;
  for (int round = 0; round < rounds; ++round) {
    for (Counter& counter : counters) {
      const WideProduct p0 = wide_product(0xD2E7470EE14C6C93u, counter[0]);
      const WideProduct p1 = wide_product(0xCA5A826395121157u, counter[2]);
      counter = {p1.high ^ counter[1] ^ key[0], p1.low, p0.high ^ counter[3] ^ key[1], p0.low};
    }
    key[0] += 0x9E3779B97F4A7C15u;  // golden ratio
    key[1] += 0xBB67AE8584CAA73Bu;  // sqrt(3) - 1
  }
}

Counter counter_of(const RandomKey& key, std::uint64_t block) {
  return {key.step, key.joint, key.walker, block};
}
Key key_of(const RandomKey& key) { return {key.seed, static_cast<std::uint64_t>(key.domain)}; }

}  // namespace

std::array<std::uint64_t, 4> philox4x64(std::array<std::uint64_t, 4> counter,
                                        std::array<std::uint64_t, 2> key) {
  std::array<Counter, 1> counters{counter};
  philox_all(counters, key);
  return counters[0];
}

void random_directions(RandomKey key, bool planar, std::span<Vec3> out) {
  constexpr std::size_t batch = 4;
  const std::uint64_t first = key.joint;
  std::array<Counter, batch> blocks;
  for (std::size_t begin = 0; begin < out.size(); begin += batch) {
    for (std::size_t i = 0; i < batch; ++i) {
      key.joint = first + begin + i;
      blocks[i] = counter_of(key, 0);
    }
    philox_all(blocks, key_of(key));
    for (std::size_t i = 0; i < batch && begin + i < out.size(); ++i) {
      key.joint = first + begin + i;
      RandomSequence draws(key, blocks[i]);
      out[begin + i] = planar ? draws.direction_in_plane() : draws.direction();
    }
  }
}

/// Four draws a block; the last word of the counter numbers the blocks of one sequence.
std::uint64_t RandomSequence::bits() {
  const std::uint64_t lane = drawn_ % 4;
  if (lane == 0 && !(has_first_ && drawn_ == 0))
    block_ = philox4x64(counter_of(key_, drawn_ / 4), key_of(key_));
  ++drawn_;
  return block_[lane];
}

double RandomSequence::uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }

std::uint64_t RandomSequence::below(std::uint64_t bound) {
  WideProduct product = wide_product(bits(), bound);
  if (product.low < bound) {
    const std::uint64_t threshold = (0 - bound) % bound;
    while (product.low < threshold) product = wide_product(bits(), bound);
  }
  return product.high;
}

Vec3 RandomSequence::direction() {
  for (;;) {
    const double u = 2.0 * uniform() - 1.0;
    const double v = 2.0 * uniform() - 1.0;
    const double s = u * u + v * v;
    if (s >= 1.0) continue;
    const double root = 2.0 * std::sqrt(1.0 - s);
    return {u * root, v * root, 1.0 - 2.0 * s};
  }
}

Vec3 RandomSequence::direction_in_plane() {
  for (;;) {
    const double u = 2.0 * uniform() - 1.0;
    const double v = 2.0 * uniform() - 1.0;
    const double s = u * u + v * v;
    if (s >= 1.0 || s == 0.0) continue;
    const double length = std::sqrt(s);
    return {u / length, v / length, 0.0};
  }
}

}  // namespace pliant
