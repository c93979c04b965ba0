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
    found_.assign(things_, is_held);
    for (LimitIndex k = 0; k < limits_.size(); ++k) {
      const Limit& limit = limits_[k];
      const double length = distance(positions[limit.a], positions[limit.b]);
      std::uint8_t& found = found_[thing_[k]];
      if (is_off(off, k))
        found = is_switched_off;
      else if (!std::isfinite(length) || std::abs(excess(limit, length)) > tolerance)
        found = std::max<std::uint8_t>(found, is_broken);
    }
    return {std::ranges::count(found_, is_held), std::ranges::count(found_, is_broken),
            std::ranges::count(found_, is_switched_off)};
  }

 private:
  /// The worst that is known of a thing; more outdoes less.
  static constexpr std::uint8_t is_held = 0, is_broken = 1, is_switched_off = 2;

  std::vector<Limit> limits_;
  std::vector<std::uint32_t> thing_;  ///< (L) that each limit stands for
  std::size_t things_ = 0;
  std::vector<std::uint8_t> found_;  ///< scratch of count()
};

}  // namespace pliant
