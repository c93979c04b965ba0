// SPDX-License-Identifier: MIT
// What holds a pull, in words.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "document.hpp"
#include "pliant/run/held_pull.hpp"

namespace pliant::play {

/// A holder, or several of one pair.
struct HolderLine {
  std::string text;  ///< "hydrogen bond GLY10:N – VAL17:O"
  std::string what;  ///< "hydrogen bond", "pin", "touch"
  Joint a = 0, b = 0;
  double load = 0.0;  ///< share of the pull
  bool may_be_cut = false;
};

/// `start` is the document before all edits, whose contacts have the numbers of groups of limits;
/// `shown` the one after them.
struct HeldWords {
  const Document& start;
  const Document& shown;
  const Framework& framework;  ///< of the walk, with pins
  Joint joint;
  const HeldPull& held;

  std::vector<HolderLine> lines() const;
  std::string said() const;
  /// Whether it gets no further in the trial steps than what counts as held.
  bool is_held() const;

 private:
  /// What carries the pull: all of it, what can be taken away, or what cannot.
  enum class Which : std::uint8_t { all, removable, lasting };
  std::string carried(Which which) const;
  bool has_removable() const;
  std::string own_shape() const;
  std::string cluster() const;
  std::string trial() const;
};

}  // namespace pliant::play
