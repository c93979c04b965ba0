// SPDX-License-Identifier: MIT
// One number of each of eight walkers (lanes) side by side in SIMD registers, with the arithmetic
// of double: each operation rounds in each lane exactly as it does alone (IEEE 754), so that a
// walker's numbers depend neither on its neighbours nor on the width of the registers.
//
// Written in the vector extensions of gcc and clang. The same source is compiled once for each
// level of instructions, in a namespace of that level, so that no function of one level is linked
// into another. Only the kernels of lane_level.cpp include this header.
#pragma once

#include <cstdint>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#ifndef PLIANT_LANE_LEVEL
#define PLIANT_LANE_LEVEL lanes_portable
#endif

#define PLIANT_LANE_INLINE __attribute__((always_inline)) inline

namespace pliant::PLIANT_LANE_LEVEL {

#if defined(__AVX512F__)
#define PLIANT_LANE_BYTES 64
#elif defined(__AVX__)
#define PLIANT_LANE_BYTES 32
#else
#define PLIANT_LANE_BYTES 16
#endif

using Doubles = double __attribute__((vector_size(PLIANT_LANE_BYTES)));
using Integers = std::int64_t __attribute__((vector_size(PLIANT_LANE_BYTES)));
using Truths = decltype(Doubles{} < Doubles{});

inline constexpr int width = PLIANT_LANE_BYTES / 8;  ///< lanes in a register
inline constexpr int pieces = 8 / width;             ///< registers for eight lanes

/// Eight lanes: calls `make(i)` for register i.
template <class Eight, class Make>
PLIANT_LANE_INLINE Eight made_of(Make make) {
  Eight made;
  for (int i = 0; i < pieces; ++i) made.v[i] = make(i);
  return made;
}

/// True or false in each lane.
struct Mask {
  Truths v[pieces];

  friend PLIANT_LANE_INLINE Mask operator&(const Mask& a, const Mask& b) {
    return made_of<Mask>([&](int i) { return a.v[i] & b.v[i]; });
  }
  friend PLIANT_LANE_INLINE Mask operator|(const Mask& a, const Mask& b) {
    return made_of<Mask>([&](int i) { return a.v[i] | b.v[i]; });
  }
  friend PLIANT_LANE_INLINE Mask operator~(const Mask& a) {
    return made_of<Mask>([&](int i) { return ~a.v[i]; });
  }
  friend PLIANT_LANE_INLINE Mask operator!(const Mask& a) { return ~a; }  // as !bool
  PLIANT_LANE_INLINE Mask& operator&=(const Mask& b) { return *this = *this & b; }
  PLIANT_LANE_INLINE Mask& operator|=(const Mask& b) { return *this = *this | b; }

  /// The mask with bit l of `bits` in lane l.
  static PLIANT_LANE_INLINE Mask of(unsigned bits) {
    return made_of<Mask>([&](int i) {
      Integers one_bit;
      for (int lane = 0; lane < width; ++lane) one_bit[lane] = std::int64_t{1} << lane;
      return (one_bit & (Integers{} + std::int64_t(bits >> i * width))) != Integers{};
    });
  }
  static PLIANT_LANE_INLINE Mask all(bool value) { return of(value ? 0xff : 0); }

  /// The lanes as bits.
  PLIANT_LANE_INLINE std::uint8_t bits() const {
    int found = 0;
    for (int i = 0; i < pieces; ++i) found |= bits_of(v[i]) << i * width;
    return static_cast<std::uint8_t>(found);
  }

 private:
  static PLIANT_LANE_INLINE int bits_of(Truths piece) {
#if defined(__AVX512DQ__)
    return _mm512_movepi64_mask(reinterpret_cast<__m512i>(piece));
#elif defined(__AVX__)
    return _mm256_movemask_pd(reinterpret_cast<__m256d>(piece));
#elif defined(__SSE2__)
    return _mm_movemask_pd(reinterpret_cast<__m128d>(piece));
#else
    int found = 0;
    for (int lane = 0; lane < width; ++lane) found |= (piece[lane] != 0 ? 1 : 0) << lane;
    return found;
#endif
  }
};

/// A double in each lane.
struct Lanes {
  Doubles v[pieces];

  Lanes() = default;
  PLIANT_LANE_INLINE Lanes(double s) {
    for (int i = 0; i < pieces; ++i)
      for (int lane = 0; lane < width; ++lane) v[i][lane] = s;
  }

  PLIANT_LANE_INLINE double get(int lane) const { return v[lane / width][lane % width]; }
  PLIANT_LANE_INLINE void set(int lane, double to) { v[lane / width][lane % width] = to; }

  friend PLIANT_LANE_INLINE Lanes operator+(const Lanes& a, const Lanes& b) {
    return made_of<Lanes>([&](int i) { return a.v[i] + b.v[i]; });
  }
  friend PLIANT_LANE_INLINE Lanes operator-(const Lanes& a, const Lanes& b) {
    return made_of<Lanes>([&](int i) { return a.v[i] - b.v[i]; });
  }
  friend PLIANT_LANE_INLINE Lanes operator*(const Lanes& a, const Lanes& b) {
    return made_of<Lanes>([&](int i) { return a.v[i] * b.v[i]; });
  }
  friend PLIANT_LANE_INLINE Lanes operator/(const Lanes& a, const Lanes& b) {
    return made_of<Lanes>([&](int i) { return a.v[i] / b.v[i]; });
  }
  friend PLIANT_LANE_INLINE Lanes operator-(const Lanes& a) {
    return made_of<Lanes>([&](int i) { return -a.v[i]; });
  }
  PLIANT_LANE_INLINE Lanes& operator+=(const Lanes& b) { return *this = *this + b; }
  PLIANT_LANE_INLINE Lanes& operator-=(const Lanes& b) { return *this = *this - b; }
  PLIANT_LANE_INLINE Lanes& operator*=(const Lanes& b) { return *this = *this * b; }

  friend PLIANT_LANE_INLINE Mask operator<(const Lanes& a, const Lanes& b) {
    return made_of<Mask>([&](int i) { return a.v[i] < b.v[i]; });
  }
  friend PLIANT_LANE_INLINE Mask operator<=(const Lanes& a, const Lanes& b) {
    return made_of<Mask>([&](int i) { return a.v[i] <= b.v[i]; });
  }
  friend PLIANT_LANE_INLINE Mask operator>(const Lanes& a, const Lanes& b) { return b < a; }
  friend PLIANT_LANE_INLINE Mask operator>=(const Lanes& a, const Lanes& b) { return b <= a; }
};

/// `yes` where the mask is true, else `no`.
PLIANT_LANE_INLINE Lanes select(const Mask& mask, const Lanes& yes, const Lanes& no) {
  return made_of<Lanes>([&](int i) { return mask.v[i] ? yes.v[i] : no.v[i]; });
}

PLIANT_LANE_INLINE Lanes sqrt(const Lanes& a) {
  return made_of<Lanes>([&](int i) {
    Doubles root;
    for (int lane = 0; lane < width; ++lane) root[lane] = __builtin_sqrt(a.v[i][lane]);
    return root;
  });
}

PLIANT_LANE_INLINE Lanes abs(const Lanes& a) {
  return made_of<Lanes>([&](int i) {
    const Integers all_but_sign = Integers{} + std::int64_t{0x7fffffffffffffff};
    return reinterpret_cast<Doubles>(reinterpret_cast<Integers>(a.v[i]) & all_but_sign);
  });
}

/// As std::max and std::min: the first of two that are equal or not comparable.
PLIANT_LANE_INLINE Lanes max(const Lanes& a, const Lanes& b) { return select(a < b, b, a); }
PLIANT_LANE_INLINE Lanes min(const Lanes& a, const Lanes& b) { return select(b < a, b, a); }

/// A point (Angstrom) or a vector in each lane.
struct LaneVec3 {
  Lanes x, y, z;

  friend PLIANT_LANE_INLINE LaneVec3 operator+(const LaneVec3& a, const LaneVec3& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  friend PLIANT_LANE_INLINE LaneVec3 operator-(const LaneVec3& a, const LaneVec3& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  friend PLIANT_LANE_INLINE LaneVec3 operator*(const Lanes& s, const LaneVec3& a) {
    return {s * a.x, s * a.y, s * a.z};
  }
  PLIANT_LANE_INLINE LaneVec3& operator+=(const LaneVec3& o) {
    return x += o.x, y += o.y, z += o.z, *this;
  }
  PLIANT_LANE_INLINE LaneVec3& operator-=(const LaneVec3& o) {
    return x -= o.x, y -= o.y, z -= o.z, *this;
  }
};

PLIANT_LANE_INLINE Lanes dot(const LaneVec3& a, const LaneVec3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
PLIANT_LANE_INLINE Lanes norm_squared(const LaneVec3& a) { return dot(a, a); }
PLIANT_LANE_INLINE LaneVec3 select(const Mask& mask, const LaneVec3& yes, const LaneVec3& no) {
  return {select(mask, yes.x, no.x), select(mask, yes.y, no.y), select(mask, yes.z, no.z)};
}

}  // namespace pliant::PLIANT_LANE_LEVEL
