// SPDX-License-Identifier: MIT
#include "pliant/base/random.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <set>
#include <vector>

namespace pliant {
namespace random_test {

using Block = std::array<std::uint64_t, 4>;

/// Known answers of Random123 (kat_vectors, philox4x64 10): counters and keys of zeros, of ones,
/// and of the digits of pi.
TEST(Philox, GivesTheKnownAnswersOfRandom123) {
  constexpr std::uint64_t ones = ~std::uint64_t{0};
  EXPECT_EQ(philox4x64({0, 0, 0, 0}, {0, 0}), (Block{0x16554d9eca36314cu, 0xdb20fe9d672d0fdcu,
                                                     0xd7e772cee186176bu, 0x7e68b68aec7ba23bu}));
  EXPECT_EQ(
      philox4x64({ones, ones, ones, ones}, {ones, ones}),
      (Block{0x87b092c3013fe90bu, 0x438c3c67be8d0224u, 0x9cc7d7c69cd777b6u, 0xa09caebf594f0ba0u}));
  EXPECT_EQ(
      philox4x64(
          {0x243f6a8885a308d3u, 0x13198a2e03707344u, 0xa4093822299f31d0u, 0x082efa98ec4e6c89u},
          {0x452821e638d01377u, 0xbe5466cf34e90c6cu}),
      (Block{0xa528f45403e61d95u, 0x38c72dbd566e9788u, 0xa5a1610e72fd18b5u, 0x57bd43b5e52b7fe6u}));
}

/// Flipping any one bit of counter or key flips about half of the 256 bits of the block.
TEST(Philox, EveryInputBitMatters) {
  const Block plain = philox4x64({1, 2, 3, 4}, {5, 6});
  for (int bit = 0; bit < 6 * 64; ++bit) {
    std::array<std::uint64_t, 4> counter{1, 2, 3, 4};
    std::array<std::uint64_t, 2> key{5, 6};
    (bit < 256 ? counter[std::size_t(bit / 64)] : key[std::size_t(bit / 64 - 4)]) ^=
        std::uint64_t{1} << bit % 64;
    const Block flipped = philox4x64(counter, key);
    int changed = 0;
    for (std::size_t k = 0; k < 4; ++k) changed += std::popcount(plain[k] ^ flipped[k]);
    EXPECT_GT(changed, 128 - 48) << bit;  // six standard deviations
    EXPECT_LT(changed, 128 + 48) << bit;
  }
}

TEST(RandomSequence, DependsOnEachFieldOfItsKey) {
  std::set<std::uint64_t> first;
  const RandomKey keys[] = {
      {},          {.seed = 1}, {.domain = Domain::force}, {.domain = Domain::order}, {.walker = 1},
      {.step = 1}, {.joint = 1}};
  for (const RandomKey& key : keys) first.insert(RandomSequence(key).bits());
  EXPECT_EQ(first.size(), std::size(keys));
}

TEST(RandomSequence, IsTheBlocksOfItsKeyOneAfterTheOther) {
  RandomSequence draws({7, Domain::force, 8, 9, 10});
  for (std::uint64_t block = 0; block < 3; ++block)
    for (std::uint64_t word : philox4x64({9, 10, 8, block}, {7, 2})) EXPECT_EQ(draws.bits(), word);
}

TEST(RandomSequence, UniformIsInTheUnitIntervalWithItsMoments) {
  RandomSequence draws({.seed = 3});
  double sum = 0.0, squares = 0.0;
  constexpr int count = 100000;
  for (int k = 0; k < count; ++k) {
    const double u = draws.uniform();
    ASSERT_GE(u, 0.0);
    ASSERT_LT(u, 1.0);
    sum += u;
    squares += u * u;
  }
  EXPECT_NEAR(sum / count, 1.0 / 2.0, 0.005);
  EXPECT_NEAR(squares / count, 1.0 / 3.0, 0.005);
}

TEST(RandomSequence, BelowIsEven) {
  RandomSequence draws({.seed = 4});
  int hits[7] = {};
  for (int k = 0; k < 70000; ++k) ++hits[draws.below(7)];
  for (int count : hits) EXPECT_NEAR(count, 10000, 500);
  for (int k = 0; k < 100; ++k) EXPECT_EQ(draws.below(1), 0u);
}

/// A bound just above half of the range refuses nearly half of the draws: the way round is walked.
TEST(RandomSequence, BelowAHugeBoundIsBelowIt) {
  RandomSequence draws({.seed = 5});
  constexpr std::uint64_t bound = (std::uint64_t{1} << 63) + 1;
  int upper_half = 0;
  for (int k = 0; k < 10000; ++k) {
    const std::uint64_t drawn = draws.below(bound);
    ASSERT_LT(drawn, bound);
    upper_half += drawn > bound / 2;
  }
  EXPECT_NEAR(upper_half, 5000, 300);
}

TEST(RandomSequence, DirectionsAreUnitVectorsAllAround) {
  RandomSequence draws({.seed = 6});
  Vec3 sum, squares;
  constexpr int count = 100000;
  for (int k = 0; k < count; ++k) {
    const Vec3 n = draws.direction();
    ASSERT_NEAR(norm(n), 1.0, 1e-15);
    sum += n;
    squares += {n.x * n.x, n.y * n.y, n.z * n.z};
  }
  EXPECT_LT(norm((1.0 / count) * sum), 0.01);
  for (double second_moment : {squares.x, squares.y, squares.z})
    EXPECT_NEAR(second_moment / count, 1.0 / 3.0, 0.005);
}

TEST(RandomSequence, DirectionsInThePlaneAreUnitVectorsAllAround) {
  RandomSequence draws({.seed = 7});
  Vec3 sum, squares;
  constexpr int count = 100000;
  for (int k = 0; k < count; ++k) {
    const Vec3 n = draws.direction_in_plane();
    ASSERT_NEAR(norm(n), 1.0, 1e-15);
    ASSERT_EQ(n.z, 0.0);
    sum += n;
    squares += {n.x * n.x, n.y * n.y, n.x * n.y};
  }
  EXPECT_LT(norm((1.0 / count) * sum), 0.01);
  EXPECT_NEAR(squares.x / count, 0.5, 0.005);
  EXPECT_NEAR(squares.y / count, 0.5, 0.005);
  EXPECT_NEAR(squares.z / count, 0.0, 0.005);
}

TEST(Random, ManyDirectionsAreThoseOfEachJointAlone) {
  for (const bool planar : {false, true})
    for (const std::size_t count : {0u, 1u, 3u, 4u, 1000u}) {
      RandomKey key{5, Domain::displacement, 6, 7, 90};
      std::vector<Vec3> together(count);
      random_directions(key, planar, together);
      for (std::size_t i = 0; i < count; ++i) {
        key.joint = 90 + i;
        RandomSequence alone(key);
        EXPECT_EQ(together[i], planar ? alone.direction_in_plane() : alone.direction());
      }
    }
}

}  // namespace random_test
}  // namespace pliant
