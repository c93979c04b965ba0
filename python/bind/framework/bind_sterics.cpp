// SPDX-License-Identifier: MIT
// Sterics: how near joints may come that no bar joins.
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include "arrays.hpp"
#include "pliant/base/error.hpp"
#include "pliant/framework/sterics.hpp"

namespace pliant::python {
namespace {

using OwnRow = std::tuple<std::uint32_t, std::uint32_t, double>;

std::vector<std::uint16_t> kinds_from(const ArrayLike& kinds) {
  std::vector<std::uint16_t> numbers;
  for (const std::int64_t kind : integers_from(kinds, "kinds")) {
    if (kind < 0 || kind > 65535)
      throw InputError("kinds: " + std::to_string(kind) + " is not from 0 to 65535");
    numbers.push_back(static_cast<std::uint16_t>(kind));
  }
  return numbers;
}

/// The rows of a square table, one after another.
std::vector<double> table_from(const nb::object& least, std::size_t& kind_count) {
  const nb::object table =
      nb::module_::import_("numpy").attr("asarray")(least, "dtype"_a = "float64");
  const auto shape = nb::cast<std::vector<std::size_t>>(nb::list(table.attr("shape")));
  if (shape.size() != 2 || shape[0] != shape[1])
    throw InputError("least: expected a square table, one row and column a kind");
  kind_count = shape[0];
  return reals_from({table.attr("ravel")()}, "least");
}

void make_sterics(Sterics* self, const ArrayLike& kinds, const nb::object& least,
                  const std::vector<OwnRow>& own, int excluded_bonds) {
  Sterics sterics;
  sterics.kinds = kinds_from(kinds);
  sterics.least = table_from(least, sterics.kind_count);
  for (const auto& [a, b, distance] : own) sterics.own.push_back({a, b, distance});
  sterics.excluded_bonds = excluded_bonds;
  check(sterics, sterics.kinds.size());
  new (self) Sterics(std::move(sterics));
}

nb::object least_of(const Sterics& sterics) {
  const auto kinds = static_cast<std::int64_t>(sterics.kind_count);
  return nb::cast(array_of(sterics.least)).attr("reshape")(kinds, kinds);
}

std::vector<OwnRow> own_of(const Sterics& sterics) {
  std::vector<OwnRow> rows;
  for (const OwnDistance& own : sterics.own) rows.emplace_back(own.a, own.b, own.least);
  return rows;
}

constexpr const char* sterics_doc = R"(Least distances of joints that no bar joins; immutable.

Parameters
----------
kinds : (N,) integers
    The kind of each joint, from 0.
least : (K, K) Angstrom
    Least distances of two joints by their kinds: symmetric; 0: no lower bound.
own : sequence of (a, b, least)
    Pairs of joints with another least distance (Angstrom), whatever their kinds.
excluded_bonds : int
    Pairs up to this many bars apart never touch.

Raises
------
InputError
    A table that is not square or symmetric, a kind that it does not have, a distance that is not
    from 0 to 1e5 Angstrom, a joint that does not exist, a pair stated twice.
)";

}  // namespace

void bind_sterics(nb::module_& module) {
  nb::class_<Sterics>(module, "Sterics", sterics_doc)
      .def("__init__", &make_sterics, "kinds"_a, "least"_a, nb::kw_only(),
           "own"_a = std::vector<OwnRow>(), "excluded_bonds"_a = 3)
      .def_prop_ro(
          "kinds", [](const Sterics& self) { return array_of(self.kinds); },
          nb::rv_policy::reference, "(N,) uint16, a copy: the kind of each joint.")
      .def_prop_ro("least", &least_of,
                   nb::sig("def least(self) -> numpy.typing.NDArray[numpy.float64]"),
                   "(K, K) Angstrom, a copy: least distances by kinds.")
      .def_prop_ro("own", &own_of, "Pairs of joints with least distances of their own.")
      .def_ro("excluded_bonds", &Sterics::excluded_bonds,
              "Pairs up to this many bars apart never touch.")
      .def("__repr__", [](const Sterics& self) {
        return "<pliant.Sterics: " + std::to_string(self.kinds.size()) + " joints of " +
               std::to_string(self.kind_count) + " kinds>";
      });
}

}  // namespace pliant::python
