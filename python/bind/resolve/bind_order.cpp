// SPDX-License-Identifier: MIT
// Orderings: the table, and the bars in the sequence in which a sweep visits them.
#include <nanobind/stl/filesystem.h>

#include "checks.hpp"
#include "pliant/base/error.hpp"
#include "pliant/order/ordering_file.hpp"
#include "resolve/orderings.hpp"
#include "tables.hpp"

namespace pliant::python {
namespace {

/// A column of joints or bars, none of them negative.
std::vector<std::uint32_t> indices_from(const ArrayLike& column, const char* name) {
  std::vector<std::uint32_t> indices;
  for (std::int64_t value : integers_from(column, name)) {
    if (value < 0 || value > std::numeric_limits<std::uint32_t>::max())
      fail_index(name, value, std::numeric_limits<std::uint32_t>::max());
    indices.push_back(static_cast<std::uint32_t>(value));
  }
  return indices;
}

Ordering ordering_in_file(const std::filesystem::path& path, const Framework& framework) {
  const nb::gil_scoped_release no_gil;
  return read_ordering_file(path, framework);
}

nb::tuple order(const Framework& framework, const std::string& ordering, std::int64_t root,
                std::uint64_t seed, std::uint64_t walker, std::uint64_t step) {
  const OrderingEntry& entry = find_ordering(ordering);
  OrderScratch scratch;
  Ordering visited;
  const RandomKey key{seed, Domain::order, walker, step, 0};
  if (framework.joint_count() > 0)
    entry.order({framework, joint_at(framework, root), 0, key, {}, nullptr}, scratch, visited);
  return ordering_to_python(visited);
}

void bind_ordering_file(nb::module_& module) {
  module.def(
      "read_ordering_file",
      [](const std::filesystem::path& path, const Framework& framework) {
        return ordering_to_python(ordering_in_file(path, framework));
      },
      "path"_a, "framework"_a,
      nb::sig("def read_ordering_file(path: str | os.PathLike, framework: Framework) -> "
              "tuple[numpy.typing.NDArray[numpy.uint32], "
              "numpy.typing.NDArray[numpy.uint32], numpy.typing.NDArray[numpy.bool_]]"),
      "Reads an ordering file (constraint file): (bar, near, is_tree), as ``order`` gives them.\n\n"
      "Joints are named as the framework names them, or by index. Raises InputError naming file,\n"
      "line, what was expected and what was found; each bar must be there once.");
  module.def(
      "ordering_text",
      [](const Framework& framework, const OrderingColumns& ordering) {
        return write_ordering_file(ordering_from(ordering), framework);
      },
      "framework"_a, "ordering"_a,
      "The text of an ordering file, which ``read_ordering_file`` reads back to the same "
      "visits.\n\n"
      "``ordering`` is (bar, near, is_tree), each (B,), as ``order`` gives them. Raises "
      "InputError\n"
      "unless it visits each bar of the framework once.");
}

}  // namespace

nb::tuple ordering_to_python(const Ordering& ordering) {
  std::vector<BarIndex> bar;
  std::vector<Joint> near;
  std::vector<bool> is_tree;
  for (const OrderedBar& visit : ordering) {
    bar.push_back(visit.bar);
    near.push_back(visit.near);
    is_tree.push_back(visit.is_tree);
  }
  return nb::make_tuple(array_of(std::move(bar)), array_of(std::move(near)), mask_of(is_tree));
}

Ordering ordering_from(const OrderingColumns& columns) {
  const auto bar = indices_from(std::get<0>(columns), "bar");
  const auto near = indices_from(std::get<1>(columns), "near");
  const auto is_tree = truths_from(std::get<2>(columns), "is_tree");
  if (bar.size() != near.size() || bar.size() != is_tree.size())
    throw InputError("ordering: expected three columns of one length, found " +
                     std::to_string(bar.size()) + ", " + std::to_string(near.size()) + " and " +
                     std::to_string(is_tree.size()));
  Ordering ordering;
  for (std::size_t k = 0; k < bar.size(); ++k)
    ordering.push_back({bar[k], near[k], is_tree[k] != 0});
  return ordering;
}

std::shared_ptr<const Ordering> technique_ordering(const std::optional<OrderingColumns>& columns) {
  return columns ? std::make_shared<const Ordering>(ordering_from(*columns)) : nullptr;
}

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
  bind_ordering_file(module);
}

}  // namespace pliant::python
