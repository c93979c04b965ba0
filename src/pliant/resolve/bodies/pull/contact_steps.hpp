// SPDX-License-Identifier: MIT
// Constants of steps that repair contacts, of a whole framework and of a region.
#pragma once

#include "pliant/framework/limits.hpp"

namespace pliant::froda {

// Angstrom
inline constexpr double margin = 0.01;  // steps aim inside limits, so that they end there
inline constexpr double last_bound = 0.5;
inline constexpr double least_length = 1e-9;

inline constexpr double pull_weight = 10.0;
inline constexpr double last_weight = 100.0;
/// A step gains if it takes more than a twentieth off. Without gain for so many steps it is over;
/// where something is still too near, later.
inline constexpr double least_gain = 0.95;
inline constexpr int patience = 6, long_patience = 15;

/// A first step that moves no body further (Angstrom) has carried nothing through anything:
/// contacts alone then mend what it broke.
inline constexpr double small_move = 0.1;
inline constexpr int last_pulls = 3;  // blind, then as many with contacts
/// Blind pulls of a small push end when one goes no further than this share of the first.
inline constexpr double settled_share = 0.5;

/// The interval that a step aims at.
struct Aim {
  double least, most;
};

inline Aim aim_of(const Limit& limit) {
  const double least = limit.least > 0.0 ? limit.least + margin : 0.0;
  const double most = limit.most - margin;
  return least <= most ? Aim{least, most} : Aim{limit.least, limit.most};
}

}  // namespace pliant::froda
