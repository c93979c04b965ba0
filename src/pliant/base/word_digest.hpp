// SPDX-License-Identifier: MIT
// A digest that shows whether words are those that were written.
#pragma once

#include <cstdint>

namespace pliant {

/// Digests 64-bit words, one after another. It finds what is cut, flipped or in another order, and
/// does not protect against deliberate collisions.
class WordDigest {
 public:
  void add(std::uint64_t word) {
    value_ = (value_ ^ word) * 0xff51afd7ed558ccd;
    value_ ^= value_ >> 32;
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0x9e3779b97f4a7c15;  // constants of SplitMix64 and MurmurHash3
};

}  // namespace pliant
