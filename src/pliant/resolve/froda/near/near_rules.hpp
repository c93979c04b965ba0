// SPDX-License-Identifier: MIT
// How near two places of a plan of bodies may come, by a framework's sterics, and how far a list of
// near pairs must reach for each two kinds of joints.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "pliant/base/graphs/grouped.hpp"
#include "pliant/framework/measures/contacts.hpp"
#include "pliant/resolve/froda/bodies/body_plan.hpp"

namespace pliant {

/// Angstrom: a list reaches further than it must, by the 0.01 within which steps aim at least
/// distances, and by as much again because it looks at rounded positions.
inline constexpr double list_slack = 0.02;

/// Which places next to one never touch it: itself, those of its body, and what is few bonds away.
struct NeighbourMask {
  static constexpr Slot reach = 63;      ///< places before and after it
  std::array<std::uint64_t, 2> words{};  ///< bit k: the place `reach` before it, and k on

  /// Without a branch: among places that are near each other, half are excluded.
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
  /// Both outlive it; the framework has sterics. `skin` (Angstrom): how much further than least
  /// distances a list reaches.
  NearRules(const Framework& framework, const BodyPlan& plan, double skin);

  double largest() const { return rules_.largest(); }  ///< of any pair; 0: nothing ever touches
  std::span<const Slot> listed() const { return listed_; }  ///< what may touch others: no copies
  std::uint16_t kind(Slot place) const { return kind_[place]; }
  /// Of most pairs that never touch this tells it without a search.
  const NeighbourMask& excluded_near(Slot place) const { return excluded_near_[place]; }
  /// Of places i < j that the mask does not have (Angstrom); 0 if they may come as near as they
  /// like.
  double least(Slot i, Slot j) const;
  /// (kinds) squares of how far a list reaches from a kind to each (Angstrom^2).
  const float* square_reaches(std::uint16_t kind) const {
    return square_reaches_.data() + kind * kinds_;
  }
  float widest(std::uint16_t kind) const { return widest_[kind]; }  ///< largest of them

 private:
  /// A pair whose distance is its own; 0: may come as near as it likes.
  struct Special {
    Slot other;
    double least;
  };
  void set_excluded(Slot low, Slot high, bool is_excluded);
  void exclude();
  void exclude_within_bodies();
  void set_reaches(double skin);

  const BodyPlan& plan_;
  ContactRules rules_;
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
