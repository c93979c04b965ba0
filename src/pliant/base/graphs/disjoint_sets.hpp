// SPDX-License-Identifier: MIT
// Disjoint sets (union-find) of the numbers 0 .. n - 1, each known by its lowest member.
#pragma once

#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace pliant {

class DisjointSets {
 public:
  /// Makes each number a set by itself.
  void reset(std::size_t count) {
    parent_.resize(count);
    std::iota(parent_.begin(), parent_.end(), 0U);
  }

  /// Returns the lowest number of the set that holds k; halves paths on its way.
  std::uint32_t find(std::uint32_t k) {
    while (parent_[k] != k) k = parent_[k] = parent_[parent_[k]];
    return k;
  }

  /// Unites the sets of a and b. Returns false if both were in one set already.
  bool unite(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    if (a == b) return false;
    if (b < a) std::swap(a, b);
    parent_[b] = a;
    return true;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace pliant
