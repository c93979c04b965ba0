// SPDX-License-Identifier: MIT
// How many of the things that limits stand for (molecular contacts) hold at given positions.
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

/// What a thing that limits stand for does in a frame. Numbers are those of recorded files.
enum class ContactState : std::uint8_t {
  held,    ///< on, each limit within its interval
  broken,  ///< on, some limit is not
  off      ///< switched off, wherever its joints are
};

/// Limits of one group stand for one thing; a limit of no group stands for one of its own.
struct LimitCounts {
  std::int64_t held = 0;    ///< on, each limit within its interval
  std::int64_t broken = 0;  ///< on, some limit is not
  std::int64_t off = 0;     ///< switched off, wherever its joints are
  friend bool operator==(const LimitCounts&, const LimitCounts&) = default;
};

/// Counts them frame by frame.
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

  /// How many things there are.
  std::size_t size() const { return things_; }

  /// `positions` in Angstrom; `off` (L) or empty. A limit is within its interval up to `tolerance`
  /// (Angstrom); one whose length is not finite is not. Not for two threads at once.
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

  /// (size()) Of each thing, as count() found it last, in the order of each thing's first limit.
  std::span<const ContactState> states() const { return found_; }

 private:
  std::vector<Limit> limits_;
  std::vector<std::uint32_t> thing_;  ///< (L) that each limit stands for
  std::size_t things_ = 0;
  std::vector<ContactState> found_;  ///< of the last count()
};

}  // namespace pliant
