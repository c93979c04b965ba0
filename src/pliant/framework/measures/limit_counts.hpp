// SPDX-License-Identifier: MIT
// Counts how many of the contacts that limits stand for hold at given positions.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "pliant/base/vec3.hpp"
#include "pliant/framework/limits.hpp"

namespace pliant {

/// What a contact does in a frame. The numbers are those of recorded files.
enum class ContactState : std::uint8_t {
  held,    ///< switched on, all limits within their intervals
  broken,  ///< switched on, some limit is not within its interval
  off      ///< switched off, whatever the distances
};

/// Numbers of contacts. Limits of one group stand for one contact; a limit in no group is a contact
/// by itself.
struct LimitCounts {
  std::int64_t held = 0;  ///< as ContactState
  std::int64_t broken = 0;
  std::int64_t off = 0;
  friend bool operator==(const LimitCounts&, const LimitCounts&) = default;
};

/// Counts contacts frame by frame.
class LimitCounter {
 public:
  explicit LimitCounter(std::span<const Limit> limits) : limits_(limits.begin(), limits.end()) {
    std::map<std::uint32_t, std::uint32_t> of_group;
    for (const Limit& limit : limits_) {
      const auto next = static_cast<std::uint32_t>(things_);
      const std::uint32_t thing =
          limit.group == no_limit_group ? next : of_group.emplace(limit.group, next).first->second;
      if (thing == next) ++things_;
      thing_.push_back(thing);
    }
  }

  /// Number of contacts.
  std::size_t size() const { return things_; }

  /// Counts the contacts at `positions` (Angstrom) with limits switched off by `off` ((L) or
  /// empty). A limit is within its interval up to `tolerance` (Angstrom), and never if its length
  /// is not finite. Not thread-safe.
  LimitCounts count(std::span<const Vec3> positions, LimitsOff off, double tolerance) {
    found_.assign(things_, ContactState::held);
    for (LimitIndex k = 0; k < limits_.size(); ++k) {
      const Limit& limit = limits_[k];
      const double length = distance(positions[limit.a], positions[limit.b]);
      ContactState& found = found_[thing_[k]];  // the worst that is known of it
      if (is_off(off, k))
        found = ContactState::off;
      else if (!std::isfinite(length) || std::abs(excess(limit, length)) > tolerance)
        found = std::max(found, ContactState::broken);
    }
    return {std::ranges::count(found_, ContactState::held),
            std::ranges::count(found_, ContactState::broken),
            std::ranges::count(found_, ContactState::off)};
  }

  /// Number of contacts of which a limit is switched off.
  std::int64_t off(LimitsOff off) {
    found_.assign(things_, ContactState::held);
    for (LimitIndex k = 0; k < limits_.size(); ++k)
      if (is_off(off, k)) found_[thing_[k]] = ContactState::off;
    return std::ranges::count(found_, ContactState::off);
  }

  /// (size()) the state of each contact at the last count(), in the order of their first limits.
  std::span<const ContactState> states() const { return found_; }

 private:
  std::vector<Limit> limits_;
  std::vector<std::uint32_t> thing_;  ///< (L) the contact that each limit stands for
  std::size_t things_ = 0;
  std::vector<ContactState> found_;  ///< of the last count()
};

}  // namespace pliant
