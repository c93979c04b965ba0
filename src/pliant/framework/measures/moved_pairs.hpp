// SPDX-License-Identifier: MIT
// Finds the pairs of joints that have moved since they were last visited, so that visiting all
// pairs again costs only as much as what has moved.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "pliant/base/graphs/grouped.hpp"
#include "pliant/base/vec3.hpp"

namespace pliant {

/// Positions at the last look, and which of them have moved since, in chunks of some tens of
/// joints.
class MovedPositions {
 public:
  static constexpr std::size_t joints_each = 64;

  /// Compares with the look before, bit by bit. Returns false if no joint has moved.
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

/// Pairs in the order of the caller, in groups of some hundreds.
class MovedPairs {
 public:
  static constexpr std::size_t pairs_each = 256;

  /// Takes new pairs, which have joints `a` and `b`. All groups become stale.
  template <class Pair>
  void assign(std::span<const Pair> pairs) {
    count_ = pairs.size();
    is_stale_.assign((count_ + pairs_each - 1) / pairs_each, 1);
    chunks_ = {};
    for (std::size_t group = 0; group < size(); ++group) {
      found_.clear();
      for (std::size_t k = first(group); k < last(group); ++k)
        for (const auto joint : {pairs[k].a, pairs[k].b})
          found_.push_back(static_cast<std::uint32_t>(joint / MovedPositions::joints_each));
      std::sort(found_.begin(), found_.end());
      found_.erase(std::unique(found_.begin(), found_.end()), found_.end());
      chunks_.add(found_);
    }
  }

  void note(const MovedPositions& moved) {
    for (std::size_t group = 0; group < size(); ++group) {
      if (is_stale_[group] != 0) continue;
      const auto chunks = chunks_.at(group);
      is_stale_[group] = std::any_of(chunks.begin(), chunks.end(),
                                     [&](std::uint32_t chunk) { return moved.has_moved(chunk); });
    }
  }

  void make_all_stale() { is_stale_.assign(size(), 1); }

  /// Calls look(group) for each group with a joint that has moved since the last call for it.
  template <class Look>
  void look_at_stale(const Look& look) {
    for (std::size_t group = 0; group < size(); ++group)
      if (is_stale_[group] != 0) look(group), is_stale_[group] = 0;
  }

  std::size_t size() const { return is_stale_.size(); }  ///< number of groups
  std::size_t first(std::size_t group) const { return group * pairs_each; }
  std::size_t last(std::size_t group) const { return std::min(count_, (group + 1) * pairs_each); }

 private:
  std::size_t count_ = 0;
  std::vector<std::uint8_t> is_stale_;  ///< (groups)
  Grouped<std::uint32_t> chunks_;       ///< (groups) the chunks of its joints
  std::vector<std::uint32_t> found_;
};

}  // namespace pliant
