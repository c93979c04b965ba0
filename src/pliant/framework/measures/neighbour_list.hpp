// SPDX-License-Identifier: MIT
// Neighbour list (Verlet list): the near pairs of joints of one walker.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "pliant/framework/framework.hpp"

namespace pliant {

/// A near pair: two joints a < b and their least distance.
struct NeighbourPair {
  Joint a, b;
  double least;  ///< Angstrom
  friend bool operator==(const NeighbourPair&, const NeighbourPair&) = default;
};

/// Least distances of pairs by a framework's sterics, with exclusions.
class LeastDistances {
 public:
  /// O(joints * joints within excluded_bonds).
  explicit LeastDistances(const Framework& framework);

  double largest() const { return largest_; }  ///< of any pair; 0: no pair ever touches
  /// An upper bound of of(a, b) that is quick to find.
  double at_most(Joint a, Joint b) const {
    return has_own_[a] != 0 ? largest_ : sterics_.of_kinds(a, b);
  }
  /// Least distance of joints a < b (Angstrom); 0 if there is none.
  double of(Joint a, Joint b) const;
  /// The joints above `joint` that are too few bonds away ever to touch it, ascending.
  std::span<const Joint> excluded_above(Joint joint) const {
    return {excluded_.data() + first_[joint], excluded_.data() + first_[joint + 1]};
  }

 private:
  void exclude_within(const Framework& framework);

  const Sterics& sterics_;
  double largest_;
  std::vector<OwnDistance> own_;       ///< a < b, sorted
  std::vector<std::uint8_t> has_own_;  ///< (N) 1: it is the a of an OwnDistance
  std::vector<std::size_t> first_;     ///< (N + 1) into excluded_
  std::vector<Joint> excluded_;        ///< joints above a joint that never touch it, ascending
};

/// Whether NeighbourList takes these positions: finite, and at most 1e300.
bool can_be_listed(std::span<const Vec3> positions);

/// Keeps the pairs of joints that may touch. Neither the skin nor the time at which the list was
/// made affects which overlaps a caller finds; they only affect how many pairs are visited.
class NeighbourList {
 public:
  /// The framework must have sterics, and outlive this. `skin` (Angstrom, above 0, up to 1e5) is
  /// how much further than least distances the list reaches: when a joint has moved by more than
  /// half of it, the pairs of all joints that have moved a good part of that way are listed anew.
  explicit NeighbourList(const Framework& framework, double skin = 1.0);

  /// Brings the list up to date for `positions` (N). Returns false unless can_be_listed().
  bool update(std::span<const Vec3> positions);

  /// All pairs that may overlap, and some others; sorted by a, then b.
  std::span<const NeighbourPair> near() const { return near_; }

  std::int64_t lists_made() const { return lists_made_; }

 private:
  bool is_out_of_date(std::span<const Vec3> positions) const;
  void make_list(std::span<const Vec3> positions);
  void renew_list(std::span<const Vec3> positions);
  void choose_renewed(std::span<const Vec3> positions);
  template <class Visit>
  void for_each_pair_of_renewed(const Visit& visit) const;
  void list(std::uint32_t a, std::uint32_t b, double squared);

  LeastDistances rules_;
  double skin_;
  bool made_ = false;
  std::int64_t lists_made_ = 0;
  std::vector<Vec3> listed_at_;           ///< (N) where each joint was when its pairs were listed
  std::vector<std::uint8_t> is_renewed_;  ///< (N) within renew_list()
  std::vector<Joint> renewed_;
  std::vector<NeighbourPair> near_;
};

/// The pairs that overlap at `positions` (N), each with the distance that it has there as its own:
/// what Sterics::own takes so that the start is without overlaps.
std::vector<OwnDistance> own_distances(const Framework& framework, std::span<const Vec3> positions);

}  // namespace pliant
