// SPDX-License-Identifier: MIT
// What the loops over the bars of a part look at: plain pointers into BarEquations, good until the
// next part is appended.
#pragma once

#include <cstdint>

namespace pliant {

/// Two joints, numbered from 0 within what is solved at once.
struct EquationEnds {
  std::uint32_t a, b;
};

/// Consecutive columns, bars, joints or entries.
struct PartRange {
  std::uint32_t begin = 0, end = 0;
  /// Never a function of its own, not even unoptimized: lane_level.cpp compiles it for each level
  /// of instructions, and the linker would keep any one of them.
  [[gnu::always_inline]] std::uint32_t size() const { return end - begin; }
};

/// Where the entries of L are; see SparseLdl.
struct LdlPattern {
  const std::uint32_t* column_begin;
  const std::uint32_t* rows;
  const std::uint64_t* target_begin;
  const std::uint32_t* targets;
};

/// Which bars and joints: the Part of BarEquations that is solved at once.
struct BarPattern {
  PartRange bars, joints;
  LdlPattern ldl;
  const std::uint32_t* frame_joints;  ///< of each joint here: the framework's
  const EquationEnds* ends;
  const double *rests, *allowed, *per_allowed, *diagonal_weights;  ///< of bars
  const double* weights;                                           ///< of joints
  const double* couplings;                                         ///< of entries
};

}  // namespace pliant
