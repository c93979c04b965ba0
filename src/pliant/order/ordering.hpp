// SPDX-License-Identifier: MIT
// Orderings (schedules): the sequence in which a sweep visits the bars, and from which end it looks
// at each. The table `orderings()` holds `input` and the orderings of the thesis "Motion Simulation
// of Geometric Constraint Structures", chapter 5.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "pliant/base/random.hpp"
#include "pliant/framework/framework.hpp"

namespace pliant {

/// One visit of a sweep. `near` is the end closer to the root in the traversal (for `random` and
/// `input` the bar's first joint).
struct OrderedBar {
  BarIndex bar = 0;
  Joint near = 0;
  bool is_tree = true;  ///< false: the bar closes a cycle of the traversal (non-tree bar)
};
using Ordering = std::vector<OrderedBar>;

/// Buffers that orderings reuse, so that repeated calls allocate nothing.
struct OrderScratch {
  std::vector<std::uint8_t> joint_mark, bar_mark;
  std::vector<Joint> queue;
  std::vector<std::uint32_t> next;
  std::vector<BarIndex> arrival;
  Ordering later;
};

/// What an ordering may look at.
struct OrderRequest {
  const Framework& framework;
  Joint root = 0;                        ///< the pushed joint, where traversals begin
  std::int64_t sweep = 0;                ///< 0 for the first sweep of a resolve
  RandomKey key = {};                    ///< seed, walker and step
  std::span<const Vec3> positions = {};  ///< (N) Angstrom, current positions
  const Ordering* before = nullptr;      ///< the last sweep's ordering; null in the first sweep
  const Ordering* given = nullptr;       ///< the ordering for `input`; null: the order of the bars
};

/// What happens after the first sweep of a resolve.
enum class Repeat : std::uint8_t {
  same,     ///< the same ordering in each sweep
  reverse,  ///< backwards, forwards, backwards, ...
  reorder,  ///< a new ordering before each sweep
};

/// One row of the table of orderings.
struct OrderingEntry {
  std::string_view name;
  std::string_view summary;
  Repeat repeat;
  bool forests_only = false;  ///< leaves non-tree bars out, so that it resolves only forests
  void (*order)(const OrderRequest& request, OrderScratch& scratch, Ordering& out);
};

std::span<const OrderingEntry> orderings();

/// The row of that name. Throws OptionError listing the known names.
const OrderingEntry& find_ordering(std::string_view name);

}  // namespace pliant
