// SPDX-License-Identifier: MIT
#include "pliant/resolve/bodies/near/near_hits.hpp"

#include <algorithm>
#include <array>

#if defined(__SSE2__) && defined(__GNUC__)
#define PLIANT_HAS_VECTORS
#include <immintrin.h>
#endif

namespace pliant {
namespace {

#ifdef PLIANT_HAS_VECTORS

/// The places of the bits of each mask, the lowest first.
template <class Place, std::size_t width>
consteval auto places_of_masks() {
  std::array<std::array<Place, width>, 1U << width> places{};
  for (std::uint32_t mask = 0; mask < places.size(); ++mask)
    for (std::uint32_t bit = 0, count = 0; bit < width; ++bit)
      if ((mask >> bit & 1) != 0) places[mask][count++] = static_cast<Place>(bit);
  return places;
}

/// A bit for each of the `width` points from m on that a run has, which ends at `to`.
template <std::uint32_t width>
std::uint32_t mask_of(std::uint32_t m, std::uint32_t to) {
  return (1U << std::min(to - m, width)) - 1U;
}

/// How many bits each mask of four has: a hexadecimal digit each.
constexpr std::uint64_t bits_of_four = 0x4332322132212110;

std::size_t find_by_fours(NearPoints points, std::span<const NearRun> runs, std::uint32_t k,
                          float widest, float* squares, std::uint32_t* hits) {
  static constexpr auto places_of = places_of_masks<std::uint32_t, 4>();
  const __m128 x = _mm_set1_ps(points.x[k]), y = _mm_set1_ps(points.y[k]),
               z = _mm_set1_ps(points.z[k]), most = _mm_set1_ps(widest);
  std::size_t count = 0;
  for (const NearRun run : runs)
    for (std::uint32_t m = run.from; m < run.to; m += 4) {
      const __m128 dx = _mm_sub_ps(_mm_loadu_ps(points.x + m), x);
      const __m128 dy = _mm_sub_ps(_mm_loadu_ps(points.y + m), y);
      const __m128 dz = _mm_sub_ps(_mm_loadu_ps(points.z + m), z);
      const __m128 square =
          _mm_add_ps(_mm_add_ps(_mm_mul_ps(dx, dx), _mm_mul_ps(dy, dy)), _mm_mul_ps(dz, dz));
      _mm_storeu_ps(squares + m, square);
      const auto near = static_cast<unsigned>(_mm_movemask_ps(_mm_cmplt_ps(square, most)));
      const std::uint32_t mask = near & mask_of<4>(m, run.to);
      const __m128i places =
          _mm_loadu_si128(reinterpret_cast<const __m128i*>(places_of[mask].data()));
      _mm_storeu_si128(reinterpret_cast<__m128i*>(hits + count),
                       _mm_add_epi32(places, _mm_set1_epi32(static_cast<int>(m))));
      count += bits_of_four >> 4 * mask & 15;
    }
  return count;
}

/// The same sums for twice as many points at once: the same bits.
__attribute__((target("avx2,popcnt"))) std::size_t find_by_eights(NearPoints points,
                                                                  std::span<const NearRun> runs,
                                                                  std::uint32_t k, float widest,
                                                                  float* squares,
                                                                  std::uint32_t* hits) {
  static constexpr auto places_of = places_of_masks<std::uint8_t, 8>();
  const __m256 x = _mm256_set1_ps(points.x[k]), y = _mm256_set1_ps(points.y[k]),
               z = _mm256_set1_ps(points.z[k]), most = _mm256_set1_ps(widest);
  std::size_t count = 0;
  for (const NearRun run : runs)
    for (std::uint32_t m = run.from; m < run.to; m += 8) {
      const __m256 dx = _mm256_sub_ps(_mm256_loadu_ps(points.x + m), x);
      const __m256 dy = _mm256_sub_ps(_mm256_loadu_ps(points.y + m), y);
      const __m256 dz = _mm256_sub_ps(_mm256_loadu_ps(points.z + m), z);
      const __m256 square = _mm256_add_ps(
          _mm256_add_ps(_mm256_mul_ps(dx, dx), _mm256_mul_ps(dy, dy)), _mm256_mul_ps(dz, dz));
      _mm256_storeu_ps(squares + m, square);
      const auto near =
          static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(square, most, _CMP_LT_OQ)));
      const std::uint32_t mask = near & mask_of<8>(m, run.to);
      const __m128i places =
          _mm_loadl_epi64(reinterpret_cast<const __m128i*>(places_of[mask].data()));
      _mm256_storeu_si256(
          reinterpret_cast<__m256i*>(hits + count),
          _mm256_add_epi32(_mm256_cvtepu8_epi32(places), _mm256_set1_epi32(static_cast<int>(m))));
      count += static_cast<std::size_t>(__builtin_popcount(mask));
    }
  return count;
}

#else

/// No branch, for which are near is anyone's guess.
std::size_t find_one_by_one(NearPoints points, std::span<const NearRun> runs, std::uint32_t k,
                            float widest, float* squares, std::uint32_t* hits) {
  std::size_t count = 0;
  for (const NearRun run : runs)
    for (std::uint32_t m = run.from; m < run.to; ++m) {
      const float dx = points.x[m] - points.x[k], dy = points.y[m] - points.y[k],
                  dz = points.z[m] - points.z[k];
      squares[m] = dx * dx + dy * dy + dz * dz;
      hits[count] = m;
      count += squares[m] < widest ? 1 : 0;
    }
  return count;
}

#endif

}  // namespace

std::span<const FindNearHits> near_hits_finders() {
#ifdef PLIANT_HAS_VECTORS
  static constexpr FindNearHits all[] = {find_by_fours, find_by_eights};
  static const std::size_t count =
      __builtin_cpu_supports("avx2") && __builtin_cpu_supports("popcnt") ? 2 : 1;
#else
  static constexpr FindNearHits all[] = {find_one_by_one};
  static const std::size_t count = 1;
#endif
  return {all, count};
}

}  // namespace pliant
