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

/// A range of columns, bars, joints or entries: those from `begin` to before `end`.
struct PartRange {
  std::uint32_t begin = 0, end = 0;
  /// Never a function of its own, not even unoptimized: lane_level.cpp compiles it for each level
  /// of instructions, and the linker would keep any one of them.
  [[gnu::always_inline]] std::uint32_t size() const { return end - begin; }
};

/// Where the entries of L (of L D L^T, below the diagonal) are, column after column. Eliminating
/// a column changes one entry for each pair of its own, (row, k) and (column, k): the entry
/// (row, column), which SparseLdl found once.
struct LdlPattern {
  const std::uint32_t* column_begin;  ///< of each column, and one more: its first entry
  const std::uint32_t* rows;          ///< of each entry
  const std::uint64_t* target_begin;  ///< of each column, and one more: its first target
  const std::uint32_t* targets;       ///< for each pair of entries of a column: the one it changes
};

/// The bars and joints of one Part of BarEquations, which are solved at once.
struct BarPattern {
  PartRange bars, joints;
  LdlPattern ldl;
  const std::uint32_t* frame_joints;  ///< of each joint here: its number in the framework
  const EquationEnds* ends;
  const double *rests, *allowed, *per_allowed, *diagonal_weights;  ///< of bars
  const double* weights;                                           ///< of joints
  const double* couplings;                                         ///< of entries
};

}  // namespace pliant
