// SPDX-License-Identifier: MIT
#include "pliant/base/random.hpp"

#include <cmath>

namespace pliant {
namespace {

struct Product {
  std::uint64_t high, low;
};

Product multiply(std::uint64_t a, std::uint64_t b) {
  __extension__ using Wide = unsigned __int128;
  const Wide product = static_cast<Wide>(a) * b;
  return {static_cast<std::uint64_t>(product >> 64), static_cast<std::uint64_t>(product)};
}

}  // namespace

std::array<std::uint64_t, 4> philox4x64(std::array<std::uint64_t, 4> counter,
                                        std::array<std::uint64_t, 2> key) {
  constexpr int rounds = 10;
  for (int round = 0; round < rounds; ++round) {
    const Product p0 = multiply(0xD2E7470EE14C6C93u, counter[0]);
    const Product p1 = multiply(0xCA5A826395121157u, counter[2]);
    counter = {p1.high ^ counter[1] ^ key[0], p1.low, p0.high ^ counter[3] ^ key[1], p0.low};
    key[0] += 0x9E3779B97F4A7C15u;  // golden ratio
    key[1] += 0xBB67AE8584CAA73Bu;  // sqrt(3) - 1
  }
  return counter;
}

/// Four draws a block; the last word of the counter numbers the blocks of one sequence.
std::uint64_t RandomSequence::bits() {
  const std::uint64_t lane = drawn_ % 4;
  if (lane == 0)
    block_ = philox4x64({key_.step, key_.joint, key_.walker, drawn_ / 4},
                        {key_.seed, static_cast<std::uint64_t>(key_.domain)});
  ++drawn_;
  return block_[lane];
}

double RandomSequence::uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }

std::uint64_t RandomSequence::below(std::uint64_t bound) {
  Product product = multiply(bits(), bound);
  if (product.low < bound) {
    const std::uint64_t threshold = (0 - bound) % bound;
    while (product.low < threshold) product = multiply(bits(), bound);
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
