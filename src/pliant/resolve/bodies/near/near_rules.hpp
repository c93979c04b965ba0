// SPDX-License-Identifier: MIT
// Least distances between places of a plan of bodies by a framework's sterics, and the reach of a
// list of near pairs for each two kinds of joints.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "pliant/base/graphs/grouped.hpp"
#include "pliant/framework/measures/neighbour_list.hpp"
#include "pliant/resolve/bodies/tree/body_plan.hpp"

namespace pliant {

/// Angstrom by which a list reaches further than necessary: 0.01 since steps aim that much beyond
/// least distances, and as much again since it uses rounded positions.
inline constexpr double list_slack = 0.02;

/// Neighbouring places that never touch a place: itself, those of its body, and those few bonds
/// away.
struct NeighbourMask {
  static constexpr Slot reach = 63;      ///< places before and after it
  std::array<std::uint64_t, 2> words{};  ///< bit k: the place k - `reach` after it

  /// Without a branch, because half of the places near each other are excluded.
  bool has(Slot own, Slot other) const {
    const Slot bit = other - own + reach;  // far ones before it wrap around
    return ((words[bit >> 6 & 1] >> (bit & 63)) & static_cast<std::uint64_t>(bit < 128)) != 0;
  }
  void set(Slot own, Slot other, bool is_excluded) {
    const Slot bit = other - own + reach;
    const std::uint64_t one = std::uint64_t{1} << (bit & 63);
    std::uint64_t& word = words[bit >> 6];
    word = is_excluded ? word | one : word & ~one;
  }
};

class NearRules {
 public:
  /// Both must outlive it; the framework has sterics. `skin` (Angstrom) is how much further than
  /// least distances a list reaches.
  NearRules(const Framework& framework, const BodyPlan& plan, double skin);

  double largest() const { return rules_.largest(); }  ///< of any pair; 0: no pair ever touches
  /// places that may touch others, without copies
  std::span<const Slot> listed() const { return listed_; }
  std::uint16_t kind(Slot place) const { return kind_[place]; }
  /// Recognizes most pairs that never touch without a search.
  const NeighbourMask& excluded_near(Slot place) const { return excluded_near_[place]; }
  /// Least distance of places i < j that the mask does not exclude (Angstrom); 0 if there is none.
  double least(Slot i, Slot j) const;
  /// (kinds) squared reach of a list from a kind to each (Angstrom^2).
  const float* square_reaches(std::uint16_t kind) const {
    return square_reaches_.data() + kind * kinds_;
  }
  float widest(std::uint16_t kind) const { return widest_[kind]; }  ///< largest of them

 private:
  /// A pair with its own least distance; 0: no lower bound.
  struct Special {
    Slot other;
    double least;
  };
  void set_excluded(Slot low, Slot high, bool is_excluded);
  void exclude();
  void exclude_within_bodies();
  void set_reaches(double skin);

  const BodyPlan& plan_;
  LeastDistances rules_;
  const Sterics& sterics_;
  std::vector<NeighbourMask> excluded_near_;
  Grouped<Special> special_;         ///< of each place, with higher ones
  std::vector<std::uint16_t> kind_;  ///< of each place, below kinds_
  std::size_t kinds_ = 0;
  std::vector<float> square_reaches_;  ///< (kinds * kinds)
  std::vector<float> widest_;          ///< (kinds)
  std::vector<Slot> listed_;
};

}  // namespace pliant
