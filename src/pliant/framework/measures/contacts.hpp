// SPDX-License-Identifier: MIT
// Contacts (neighbour list, Verlet list): the pairs of joints near each other now, of one walker.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "pliant/framework/framework.hpp"

namespace pliant {

/// Two joints a < b and how near they may come.
struct Contact {
  Joint a, b;
  double least;  ///< Angstrom
  friend bool operator==(const Contact&, const Contact&) = default;
};

/// Least distances of pairs by a framework's sterics, exclusions worked out.
class ContactRules {
 public:
  /// O(joints * joints within excluded_bonds).
  explicit ContactRules(const Framework& framework);

  double largest() const { return largest_; }  ///< of any pair; 0: nothing ever touches
  /// No less than of(a, b), and quick to tell.
  double at_most(Joint a, Joint b) const {
    return has_own_[a] != 0 ? largest_ : sterics_.of_kinds(a, b);
  }
  /// Of joints a < b (Angstrom); 0 if they may come as near as they like.
  double of(Joint a, Joint b) const;
  /// The joints above `joint` that are so few bonds away that the two never touch, ascending.
  std::span<const Joint> excluded_above(Joint joint) const {
    return {excluded_.data() + first_[joint], excluded_.data() + first_[joint + 1]};
  }

 private:
  void exclude_within(const Framework& framework);

  const Sterics& sterics_;
  double largest_;
  std::vector<OwnDistance> own_;       ///< a < b, sorted
  std::vector<std::uint8_t> has_own_;  ///< (N) 1: it is the a of one of these
  std::vector<std::size_t> first_;     ///< (N + 1) into excluded_
  std::vector<Joint> excluded_;        ///< joints above a joint that never touch it, ascending
};

/// Whether Contacts takes these positions: finite, and at most 1e300.
bool can_be_listed(std::span<const Vec3> positions);

/// Knows which pairs of joints may touch. Which of them a caller sees does not depend on the skin
/// nor on when the list was made: only how much is looked at does.
class Contacts {
 public:
  /// The framework must have sterics, and outlive this. `skin` (Angstrom, above 0, up to 1e5) is
  /// how much further than least distances the list reaches: when a joint has moved by more than
  /// half of it, the pairs of all that have come a good part of that way are listed anew.
  explicit Contacts(const Framework& framework, double skin = 1.0);

  /// Makes the list right for `positions` (N). False unless can_be_listed().
  bool update(std::span<const Vec3> positions);

  /// All pairs that may overlap, and others near; by a, then b.
  std::span<const Contact> near() const { return near_; }

  std::int64_t lists_made() const { return lists_made_; }

 private:
  bool is_out_of_date(std::span<const Vec3> positions) const;
  void make_list(std::span<const Vec3> positions);
  void renew_list(std::span<const Vec3> positions);
  void choose_renewed(std::span<const Vec3> positions);
  template <class Visit>
  void for_each_pair_of_renewed(const Visit& visit) const;
  void list(std::uint32_t a, std::uint32_t b, double squared);

  ContactRules rules_;
  double skin_;
  bool made_ = false;
  std::int64_t lists_made_ = 0;
  std::vector<Vec3> listed_at_;           ///< (N) where each joint was when its pairs were listed
  std::vector<std::uint8_t> is_renewed_;  ///< (N) within renew_list()
  std::vector<Joint> renewed_;
  std::vector<Contact> near_;
};

/// The pairs that overlap at `positions` (N), each with the distance that it has there as its own:
/// what Sterics::own takes so that the start is without overlaps.
std::vector<OwnDistance> own_distances(const Framework& framework, std::span<const Vec3> positions);

}  // namespace pliant
