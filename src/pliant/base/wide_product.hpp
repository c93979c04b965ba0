// SPDX-License-Identifier: MIT
// The full 128-bit product of two 64-bit numbers, from which counter-based random numbers are made.
#pragma once

#include <cstdint>

namespace pliant {

struct WideProduct {
  std::uint64_t high, low;
  friend bool operator==(WideProduct, WideProduct) = default;
};

/// Schoolbook multiplication of 32-bit halves, for processors without a wider product.
constexpr WideProduct wide_product_of_halves(std::uint64_t a, std::uint64_t b) {
  constexpr std::uint64_t half = 0xffffffffu;
  const std::uint64_t a0 = a & half, a1 = a >> 32, b0 = b & half, b1 = b >> 32;
  const std::uint64_t low = a0 * b0;
  const std::uint64_t middle = a1 * b0 + (low >> 32);     // no carry is lost: (2^32 - 1)^2 + 2^32
  const std::uint64_t other = a0 * b1 + (middle & half);  // is less than 2^64
  return {a1 * b1 + (middle >> 32) + (other >> 32), other << 32 | (low & half)};
}

/// One instruction where the processor has it. Elsewhere (32 bits, WebAssembly) a 128-bit type
/// would cost a function call for each product.
#if defined(__x86_64__) || defined(__aarch64__) || defined(__powerpc64__) || \
    defined(__riscv) && __riscv_xlen == 64
constexpr WideProduct wide_product(std::uint64_t a, std::uint64_t b) {
  __extension__ using Wide = unsigned __int128;
  const Wide product = static_cast<Wide>(a) * b;
  return {static_cast<std::uint64_t>(product >> 64), static_cast<std::uint64_t>(product)};
}
#else
constexpr WideProduct wide_product(std::uint64_t a, std::uint64_t b) {
  return wide_product_of_halves(a, b);
}
#endif

}  // namespace pliant
