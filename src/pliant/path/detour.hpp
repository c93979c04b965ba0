// SPDX-License-Identifier: MIT
// A detour of a way that is stuck: back to a place before, then aside.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "pliant/path/march.hpp"

namespace pliant {

/// (R) random directions that change slowly along the residues, the longest of length 1. They
/// depend on the seed and the attempt alone.
std::vector<Vec3> smooth_field(std::size_t residues, std::uint64_t attempt, std::uint64_t seed);

class Detour {
 public:
  /// From some places before the last of a way that is stuck: further back, and further aside, the
  /// more attempts there were (from 1). The walker, which must outlive it, is put there.
  Detour(PathWalker& walker, const Way& stuck, std::span<const Vec3> goal, std::uint64_t attempt,
         std::uint64_t seed);

  /// One step at most, which is added to the way. False once the detour has ended.
  bool advance();
  /// From the start, with the places of the detour.
  Way& way() { return way_; }

 private:
  PathWalker& walker_;
  Way way_;
  std::vector<Vec3> goal_;
  std::vector<Vec3> aside_;  ///< (R) Angstrom a step
  int steps_ = 0;
};

}  // namespace pliant
