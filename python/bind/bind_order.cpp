// SPDX-License-Identifier: MIT
// Orderings: the table, and the bars in the sequence in which a sweep visits them.
#include "arrays.hpp"
#include "checks.hpp"
#include "pliant/order/ordering.hpp"
#include "tables.hpp"

namespace pliant::python {
namespace {

/// The visits of the first sweep, column by column.
struct Visits {
  std::vector<BarIndex> bar;
  std::vector<Joint> near;
  std::vector<bool> is_tree;
};

Visits columns_of(const Ordering& ordering) {
  Visits visits;
  for (const OrderedBar& visit : ordering) {
    visits.bar.push_back(visit.bar);
    visits.near.push_back(visit.near);
    visits.is_tree.push_back(visit.is_tree);
  }
  return visits;
}

nb::tuple order(const Framework& framework, const std::string& ordering, std::int64_t root,
                std::uint64_t seed, std::uint64_t walker, std::uint64_t step) {
  const OrderingEntry& entry = find_ordering(ordering);
  OrderScratch scratch;
  Ordering visited;
  const RandomKey key{seed, Domain::order, walker, step, 0};
  if (framework.joint_count() > 0)
    entry.order({framework, joint_at(framework, root), 0, key, {}, nullptr}, scratch, visited);
  Visits visits = columns_of(visited);
  return nb::make_tuple(array_of(std::move(visits.bar)), array_of(std::move(visits.near)),
                        mask_of(visits.is_tree));
}

}  // namespace

void bind_order(nb::module_& module) {
  nb::enum_<Repeat>(module, "Repeat", "What happens after the first sweep of a resolve.")
      .value("same", Repeat::same, "The same ordering in each sweep.")
      .value("reverse", Repeat::reverse, "Backwards, forwards, backwards, ...")
      .value("reorder", Repeat::reorder, "The ordering is asked again before each sweep.");
  bind_row<OrderingEntry>(module, "OrderingEntry", "One row of the table of orderings.")
      .def_ro("repeat", &OrderingEntry::repeat, "What happens after the first sweep.")
      .def_ro("forests_only", &OrderingEntry::forests_only,
              "Leaves bars out that close a cycle, so that only forests are resolved by it.");
  module.def(
      "orderings", [] { return rows_of(orderings()); }, nb::rv_policy::reference,
      "The table of orderings: those of the thesis \"Motion Simulation of Geometric\n"
      "Constraint Structures\", chapter 5, and ``input``.");
  module.def("order", &order, "framework"_a, "ordering"_a = "bfs_cycle", "root"_a = 0,
             nb::kw_only(), "seed"_a = 0, "walker"_a = 0, "step"_a = 0,
             nb::sig("def order(framework: Framework, ordering: str = 'bfs_cycle', "
                     "root: int = 0, *, seed: int = 0, walker: int = 0, step: int = 0) -> "
                     "tuple[numpy.typing.NDArray[numpy.uint32], "
                     "numpy.typing.NDArray[numpy.uint32], numpy.typing.NDArray[numpy.bool_]]"),
             "The bars in the sequence in which a first sweep from ``root`` visits them.\n\n"
             "Returns (bar, near, is_tree), each (K,): the index of the bar, the joint from which\n"
             "it is looked at, and False where it closes a cycle of the traversal.");
}

}  // namespace pliant::python
