// SPDX-License-Identifier: MIT
// Which of many pairs of joints have a joint that is no longer where it was when the pair was
// looked at: so that to look at all pairs again costs no more than what has moved.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "pliant/base/graphs/grouped.hpp"
#include "pliant/base/vec3.hpp"

namespace pliant {

/// Where joints were at the last look, and which have moved since, some tens of them together.
class MovedChunks {
 public:
  static constexpr std::size_t joints_each = 64;

  /// Compares with the look before, bit by bit. False if no joint has moved.
  bool look(std::span<const Vec3> positions) {
    const bool is_new = at_.size() != positions.size();
    at_.resize(positions.size());
    has_moved_.assign((positions.size() + joints_each - 1) / joints_each, 0);
    bool has_any = is_new;
    for (std::size_t chunk = 0; chunk < has_moved_.size(); ++chunk) {
      const std::size_t first = chunk * joints_each;
      const auto now = positions.subspan(first, std::min(joints_each, at_.size() - first));
      if (!is_new && have_same_bits(now, &at_[first])) continue;
      std::copy(now.begin(), now.end(), at_.begin() + std::ptrdiff_t(first));
      has_moved_[chunk] = 1;
      has_any = true;
    }
    return has_any;
  }

  bool has_moved(std::uint32_t chunk) const { return has_moved_[chunk] != 0; }

 private:
  /// Without a branch for each number, which is many times faster than memcmp() of WebAssembly.
  static bool have_same_bits(std::span<const Vec3> one, const Vec3* other) {
    const auto differ = [](double a, double b) {
      return std::bit_cast<std::uint64_t>(a) ^ std::bit_cast<std::uint64_t>(b);
    };
    std::uint64_t bits = 0;
    for (std::size_t k = 0; k < one.size(); ++k)
      bits |= differ(one[k].x, other[k].x) | differ(one[k].y, other[k].y) |
              differ(one[k].z, other[k].z);
    return bits == 0;
  }

  std::vector<Vec3> at_;
  std::vector<std::uint8_t> has_moved_;
};

/// Pairs in the order of the caller, some hundreds of which are a block.
class PairBlocks {
 public:
  static constexpr std::size_t pairs_each = 256;

  /// Other pairs: each has joints `a` and `b`. All blocks are stale.
  template <class Pair>
  void assign(std::span<const Pair> pairs) {
    count_ = pairs.size();
    is_stale_.assign((count_ + pairs_each - 1) / pairs_each, 1);
    chunks_ = {};
    for (std::size_t block = 0; block < size(); ++block) {
      found_.clear();
      for (std::size_t k = first(block); k < last(block); ++k)
        for (const auto joint : {pairs[k].a, pairs[k].b})
          found_.push_back(static_cast<std::uint32_t>(joint / MovedChunks::joints_each));
      std::sort(found_.begin(), found_.end());
      found_.erase(std::unique(found_.begin(), found_.end()), found_.end());
      chunks_.add(found_);
    }
  }

  void note(const MovedChunks& moved) {
    for (std::size_t block = 0; block < size(); ++block) {
      if (is_stale_[block] != 0) continue;
      const auto chunks = chunks_.at(block);
      is_stale_[block] = std::any_of(chunks.begin(), chunks.end(),
                                     [&](std::uint32_t chunk) { return moved.has_moved(chunk); });
    }
  }

  void make_all_stale() { is_stale_.assign(size(), 1); }

  /// Calls look(block) for each that has a moved joint since it was looked at last.
  template <class Look>
  void look_at_stale(const Look& look) {
    for (std::size_t block = 0; block < size(); ++block)
      if (is_stale_[block] != 0) look(block), is_stale_[block] = 0;
  }

  std::size_t size() const { return is_stale_.size(); }  ///< blocks
  std::size_t first(std::size_t block) const { return block * pairs_each; }
  std::size_t last(std::size_t block) const { return std::min(count_, (block + 1) * pairs_each); }

 private:
  std::size_t count_ = 0;
  std::vector<std::uint8_t> is_stale_;  ///< of each block
  Grouped<std::uint32_t> chunks_;       ///< of each block: where its joints are
  std::vector<std::uint32_t> found_;
};

}  // namespace pliant
