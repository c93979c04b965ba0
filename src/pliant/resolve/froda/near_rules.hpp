// SPDX-License-Identifier: MIT
// How near two places of a plan of bodies may come, by a framework's sterics, and how far a list of
// near pairs must reach for each two kinds of joints.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "pliant/base/grouped.hpp"
#include "pliant/framework/contacts.hpp"
#include "pliant/resolve/froda/body_plan.hpp"

namespace pliant {

/// Angstrom: a list reaches a little further than it must, for it looks at rounded positions.
inline constexpr double list_slack = 0.01;

class NearRules {
 public:
  /// Both outlive it; the framework has sterics. `skin` (Angstrom): how much further than least
  /// distances a list reaches.
  NearRules(const Framework& framework, const BodyPlan& plan, double skin);

  double largest() const { return rules_.largest(); }  ///< of any pair; 0: nothing ever touches
  std::span<const Slot> listed() const { return listed_; }  ///< what may touch others: no copies
  std::uint16_t kind(Slot place) const { return kind_[place]; }
  /// Of places i < j (Angstrom); 0 if they may come as near as they like.
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
  void exclude();
  void set_reaches(double skin);

  const BodyPlan& plan_;
  ContactRules rules_;
  const Sterics& sterics_;
  std::vector<std::uint64_t> near_excluded_;  ///< of each place: bit k: place + k + 1
  Grouped<Special> special_;                  ///< of each place, with higher ones
  std::vector<std::uint16_t> kind_;           ///< of each place, below kinds_
  std::size_t kinds_ = 0;
  std::vector<float> square_reaches_;  ///< (kinds * kinds)
  std::vector<float> widest_;          ///< (kinds)
  std::vector<Slot> listed_;
};

}  // namespace pliant
