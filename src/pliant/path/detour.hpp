// SPDX-License-Identifier: MIT
// A detour of a way that is stuck: back to an earlier place, then sideways.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "pliant/path/march.hpp"

namespace pliant {

/// (R) random directions that vary smoothly along the residues, the longest of length 1. They
/// depend only on the seed and the attempt.
std::vector<Vec3> smooth_field(std::size_t residues, std::uint64_t attempt, std::uint64_t seed);

class Detour {
 public:
  /// Starts some places before the end of a way that is stuck: the more attempts (from 1), the
  /// further back and sideways. Moves the walker, which must outlive it, there.
  Detour(PathWalker& walker, const Way& stuck, std::span<const Vec3> goal, std::uint64_t attempt,
         std::uint64_t seed);

  /// Makes at most one step and adds it to the way. Returns false once the detour has ended.
  bool advance();
  /// The way from the start, detour included.
  Way& way() { return way_; }

 private:
  PathWalker& walker_;
  Way way_;
  std::vector<Vec3> goal_;
  std::vector<Vec3> aside_;  ///< (R) Angstrom a step
  int steps_ = 0;
};

}  // namespace pliant
