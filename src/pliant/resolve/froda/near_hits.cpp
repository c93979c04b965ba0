// SPDX-License-Identifier: MIT
#include "pliant/resolve/froda/near_hits.hpp"

#include <array>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace pliant {
namespace {

/// One point after another; no branch, for which are near is anyone's guess.
std::size_t find_one_by_one(const NearPoints& points, NearRun run, std::uint32_t k, float widest,
                            float* squares, std::uint32_t* hits) {
  std::size_t count = 0;
  for (std::uint32_t m = run.from; m < run.to; ++m) {
    const float dx = points.x[m] - points.x[k], dy = points.y[m] - points.y[k],
                dz = points.z[m] - points.z[k];
    squares[m] = dx * dx + dy * dy + dz * dz;
    hits[count] = m;
    count += squares[m] < widest ? 1 : 0;
  }
  return count;
}

#ifdef __SSE2__

/// The bits of a mask of four: their places, the lowest first, and how many they are.
struct MaskBits {
  std::array<std::uint32_t, 4> places{};
  std::uint32_t count = 0;
};

consteval std::array<MaskBits, 16> bits_of_masks() {
  std::array<MaskBits, 16> bits{};
  for (std::uint32_t mask = 0; mask < 16; ++mask)
    for (std::uint32_t bit = 0; bit < 4; ++bit)
      if ((mask >> bit & 1) != 0) bits[mask].places[bits[mask].count++] = bit;
  return bits;
}

constexpr auto bits_of = bits_of_masks();

/// Squared distances of points m..m+3 to (x, y, z), each four times the same.
__m128 squares_at(const NearPoints& points, std::uint32_t m, __m128 x, __m128 y, __m128 z) {
  const __m128 dx = _mm_sub_ps(_mm_loadu_ps(points.x + m), x);
  const __m128 dy = _mm_sub_ps(_mm_loadu_ps(points.y + m), y);
  const __m128 dz = _mm_sub_ps(_mm_loadu_ps(points.z + m), z);
  return _mm_add_ps(_mm_add_ps(_mm_mul_ps(dx, dx), _mm_mul_ps(dy, dy)), _mm_mul_ps(dz, dz));
}

#endif

}  // namespace

#ifdef __SSE2__

std::size_t find_near_hits(const NearPoints& points, NearRun run, std::uint32_t k, float widest,
                           float* squares, std::uint32_t* hits) {
  const __m128 x = _mm_set1_ps(points.x[k]), y = _mm_set1_ps(points.y[k]),
               z = _mm_set1_ps(points.z[k]), most = _mm_set1_ps(widest);
  std::size_t count = 0;
  std::uint32_t m = run.from;
  for (; m + 4 <= run.to; m += 4) {
    const __m128 square = squares_at(points, m, x, y, z);
    _mm_storeu_ps(squares + m, square);
    const MaskBits& bits =
        bits_of[static_cast<unsigned>(_mm_movemask_ps(_mm_cmplt_ps(square, most)))];
    const auto* places = reinterpret_cast<const __m128i*>(bits.places.data());
    const __m128i found =
        _mm_add_epi32(_mm_loadu_si128(places), _mm_set1_epi32(static_cast<int>(m)));
    _mm_storeu_si128(reinterpret_cast<__m128i*>(hits + count), found);
    count += bits.count;
  }
  return count + find_one_by_one(points, {m, run.to}, k, widest, squares, hits + count);
}

#else

std::size_t find_near_hits(const NearPoints& points, NearRun run, std::uint32_t k, float widest,
                           float* squares, std::uint32_t* hits) {
  return find_one_by_one(points, run, k, widest, squares, hits);
}

#endif

}  // namespace pliant
