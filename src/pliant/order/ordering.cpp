// SPDX-License-Identifier: MIT
#include "pliant/order/ordering.hpp"

#include <cmath>
#include <numeric>
#include <utility>

#include "pliant/base/choices.hpp"
#include "pliant/framework/measures/residual.hpp"
#include "pliant/order/traversal.hpp"

namespace pliant {
namespace {

RandomSequence draws_of(const OrderRequest& request) {
  RandomKey key = request.key;
  key.domain = Domain::order;
  key.joint = static_cast<std::uint64_t>(request.sweep);
  return RandomSequence(key);
}

void list_bars(const Framework& framework, Ordering& out) {
  const auto bars = framework.bars();
  out.clear();
  for (std::size_t k = 0; k < bars.size(); ++k)
    out.push_back({static_cast<BarIndex>(k), bars[k].a, true});
}

void order_input(const OrderRequest& request, OrderScratch&, Ordering& out) {
  if (request.given == nullptr) return list_bars(request.framework, out);
  out = *request.given;
}

/// Fisher-Yates over the bars in the order of the input.
void order_random(const OrderRequest& request, OrderScratch&, Ordering& out) {
  list_bars(request.framework, out);
  RandomSequence draws = draws_of(request);
  for (std::size_t left = out.size(); left > 1; --left)
    std::swap(out[left - 1], out[draws.below(left)]);
}

void order_bfs_tree(const OrderRequest& request, OrderScratch& scratch, Ordering& out) {
  traverse_breadth_first(request.framework, request.root, false, scratch, out);
}

void order_dfs_tree(const OrderRequest& request, OrderScratch& scratch, Ordering& out) {
  traverse_depth_first(request.framework, request.root, false, scratch, out);
}

void order_bfs_cycle(const OrderRequest& request, OrderScratch& scratch, Ordering& out) {
  traverse_breadth_first(request.framework, request.root, true, scratch, out);
}

void order_dfs_cycle(const OrderRequest& request, OrderScratch& scratch, Ordering& out) {
  traverse_depth_first(request.framework, request.root, true, scratch, out);
}

/// A sweep leaves some non-tree bars whole but for rounding: of those, as of bars equally far off,
/// the first counts, so that rounding decides nothing.
constexpr double rounding = 1e-12;

/// The near end of the non-tree bar that is furthest off; the root in the first sweep and if there
/// is none.
Joint near_end_of_worst_bar(const OrderRequest& request) {
  Joint near = request.root;
  if (request.before == nullptr) return near;
  double worst = -1.0;
  for (const OrderedBar& visit : *request.before) {
    if (visit.is_tree) continue;
    const Bar bar = request.framework.bars()[visit.bar];
    const double rest = request.framework.rest_lengths()[visit.bar];
    const double error =
        std::abs(residual(request.positions[bar.a], request.positions[bar.b], rest));
    if (error > worst + rounding * rest) {
      worst = error;
      near = visit.near;
    }
  }
  return near;
}

void order_bfs_adapt(const OrderRequest& request, OrderScratch& scratch, Ordering& out) {
  traverse_breadth_first(request.framework, near_end_of_worst_bar(request), true, scratch, out);
}

void order_bfs_random(const OrderRequest& request, OrderScratch& scratch, Ordering& out) {
  const Joint root =
      request.sweep == 0
          ? request.root
          : static_cast<Joint>(draws_of(request).below(request.framework.joint_count()));
  traverse_breadth_first(request.framework, root, true, scratch, out);
}

constexpr OrderingEntry table[] = {
    {.name = "random",
     .summary = "bars shuffled, and shuffled again before each sweep (Ragdoll physics)",
     .repeat = Repeat::reorder,
     .order = order_random},
    {.name = "bfs_tree",
     .summary = "tree bars breadth first from the pushed joint",
     .repeat = Repeat::same,
     .forests_only = true,
     .order = order_bfs_tree},
    {.name = "dfs_tree",
     .summary = "tree bars depth first from the pushed joint",
     .repeat = Repeat::same,
     .forests_only = true,
     .order = order_dfs_tree},
    {.name = "bfs_cycle",
     .summary = "all bars breadth first from the pushed joint",
     .repeat = Repeat::same,
     .order = order_bfs_cycle},
    {.name = "dfs_cycle",
     .summary = "all bars depth first from the pushed joint",
     .repeat = Repeat::same,
     .order = order_dfs_cycle},
    {.name = "bfs_reverse",
     .summary = "bfs_cycle, then backwards and forwards in turn",
     .repeat = Repeat::reverse,
     .order = order_bfs_cycle},
    {.name = "dfs_reverse",
     .summary = "dfs_cycle, then backwards and forwards in turn",
     .repeat = Repeat::reverse,
     .order = order_dfs_cycle},
    {.name = "bfs_adapt",
     .summary = "bfs_cycle, restarted at the worst non-tree bar before each sweep",
     .repeat = Repeat::reorder,
     .order = order_bfs_adapt},
    {.name = "bfs_random",
     .summary = "bfs_cycle, restarted at a random joint before each sweep",
     .repeat = Repeat::reorder,
     .order = order_bfs_random},
    {.name = "input",
     .summary = "the order of the bars in the input, or of an ordering file",
     .repeat = Repeat::same,
     .order = order_input},
};

}  // namespace

std::span<const OrderingEntry> orderings() { return table; }

const OrderingEntry& find_ordering(std::string_view name) {
  return choose(orderings(), "ordering", name);
}

}  // namespace pliant
