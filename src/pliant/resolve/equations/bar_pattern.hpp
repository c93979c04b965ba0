// SPDX-License-Identifier: MIT
// Plain pointers into BarEquations for the loops over the bars of a part, valid until the next part
// is appended.
#pragma once

#include <cstdint>

namespace pliant {

/// Two joints, numbered from 0 among those that are solved at once.
struct EquationEnds {
  std::uint32_t a, b;
};

/// A range of columns, bars, joints or entries: [begin, end).
struct PartRange {
  std::uint32_t begin = 0, end = 0;
  /// Always inlined, even without optimization: lane_level.cpp compiles it for each level of
  /// instructions, and the linker would keep any one of these.
  [[gnu::always_inline]] std::uint32_t size() const { return end - begin; }
};

/// The positions of the entries of L (of L D L^T, below the diagonal), column after column.
/// Eliminating a column changes one entry for each pair of its own, (row, k) and (column, k): the
/// entry (row, column), which SparseLdl found once.
struct LdlPattern {
  const std::uint32_t* column_begin;  ///< (columns + 1) first entry of each column
  const std::uint32_t* rows;          ///< (entries)
  const std::uint64_t* target_begin;  ///< (columns + 1) first target of each column
  const std::uint32_t* targets;       ///< the entry that each pair of entries of a column changes
};

/// The bars and joints of one Part of BarEquations, which are solved at once.
struct BarPattern {
  PartRange bars, joints;
  LdlPattern ldl;
  const std::uint32_t* frame_joints;  ///< index in the framework of each joint
  const EquationEnds* ends;
  const double *rests, *allowed, *per_allowed, *diagonal_weights;  ///< of bars
  const double* weights;                                           ///< of joints
  const double* couplings;                                         ///< of entries
};

}  // namespace pliant
