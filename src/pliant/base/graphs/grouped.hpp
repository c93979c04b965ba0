// SPDX-License-Identifier: MIT
// Grouped: things sorted into slots, one slot after the other in one array.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace pliant {

/// Lists of things, one list for each slot. `Index` is the type of the beginnings of the lists; it
/// must be able to count all things.
template <class Thing, class Index = std::uint32_t>
class Grouped {
 public:
  /// No slots.
  Grouped() = default;

  /// Sorts things into `slots` slots. `visit(put)` calls `put(slot, thing)` for each thing and is
  /// called twice: to count, and to fill. A slot has its things in the order in which they came.
  template <class Visit>
  Grouped(std::size_t slots, const Visit& visit) : first_(slots + 1, Index{0}) {
    visit([this](std::size_t slot, const Thing&) { ++first_[slot + 1]; });
    for (std::size_t k = 0; k < slots; ++k) first_[k + 1] += first_[k];
    things_.resize(first_.back());
    std::vector<Index> next(first_.begin(), first_.end() - 1);
    visit([&](std::size_t slot, const Thing& thing) { things_[next[slot]++] = thing; });
  }

  /// Adds a slot with these things after the others.
  void add(std::span<const Thing> things) {
    things_.insert(things_.end(), things.begin(), things.end());
    first_.push_back(static_cast<Index>(things_.size()));
  }
  void reserve(std::size_t slots, std::size_t things) {
    first_.reserve(slots + 1);
    things_.reserve(things);
  }

  std::size_t size() const { return first_.size() - 1; }  ///< number of slots
  std::span<const Thing> at(std::size_t slot) const {
    return {things_.data() + first_[slot], things_.data() + first_[slot + 1]};
  }
  std::span<Thing> at(std::size_t slot) {
    return {things_.data() + first_[slot], things_.data() + first_[slot + 1]};
  }
  /// Index of the first thing of a slot in things().
  std::size_t begin_of(std::size_t slot) const { return first_[slot]; }
  /// the things of all slots, one slot after the other
  std::span<const Thing> things() const { return things_; }
  std::span<Thing> things() { return things_; }

 private:
  /// (slots + 1) indices into things_
  std::vector<Index> first_ = std::vector<Index>(1, Index{0});
  std::vector<Thing> things_;
};

}  // namespace pliant
