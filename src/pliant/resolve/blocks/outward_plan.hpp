// SPDX-License-Identifier: MIT
// The outward pass: bridges and blocks in an order in which each is connected to earlier ones.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "pliant/framework/graph.hpp"

namespace pliant {

inline constexpr auto no_block = std::numeric_limits<std::uint32_t>::max();

/// A step of the pass: a bridge (near joint placed already, far joint to be moved), or a block of
/// two or more bars entered at `near`.
struct OutwardStep {
  Joint near = 0;
  Joint far = 0;                   ///< for a bridge
  BarIndex bar = 0;                ///< for a bridge
  std::uint32_t block = no_block;  ///< index into OutwardPlanner::blocks(); no_block for a bridge
};

/// Plans outward passes of one framework from any root; linear in joints + bars.
class OutwardPlanner {
 public:
  explicit OutwardPlanner(const Framework& framework);

  /// Blocks of two or more bars, each with its bars in the order of the input.
  std::span<const std::vector<BarIndex>> blocks() const { return blocks_; }

  /// Index into blocks() of a bar's block; no_block for a bridge.
  std::uint32_t block_of(BarIndex bar) const { return block_of_bar_[bar]; }

  /// Fills `out`. A component with pinned joints begins at the lowest of these; otherwise the
  /// root's component begins at the root, and others at their lowest joint.
  void plan(Joint root, std::vector<OutwardStep>& out);

 private:
  void start(Joint joint);
  void take(Joint joint, std::vector<OutwardStep>& out);
  void enter_block(std::uint32_t block, Joint entry, std::vector<OutwardStep>& out);

  const Framework& framework_;
  std::vector<std::uint32_t> block_of_bar_;
  std::vector<std::vector<BarIndex>> blocks_;
  std::vector<bool> reached_, entered_;
  std::vector<Joint> queue_;
  std::size_t next_ = 0;
};

}  // namespace pliant
