// SPDX-License-Identifier: MIT
#include "framework/limits.hpp"

#include <string>

#include "pliant/framework/limits.hpp"

namespace pliant::python {
namespace {

[[noreturn]] void refuse(std::size_t row, const char* found) {
  throw nb::type_error(("limits[" + std::to_string(row) +
                        "]: expected (a, b, least, most) and perhaps kind, energy and group, "
                        "found " +
                        found)
                           .c_str());
}

/// A value of a row; `fallback` where the row is shorter.
template <class Value>
Value value_at(const nb::object& row, std::size_t k, std::size_t index, Value fallback) {
  if (k >= nb::len(row)) return fallback;
  Value value;
  const nb::object given = nb::borrow(row[k]);
  if (!nb::try_cast(given, value))
    refuse(index, ("no number or name: " + std::string(nb::repr(given).c_str())).c_str());
  return value;
}

/// Numbers that are no joint or group become one that Framework refuses.
std::uint32_t index_from(std::int64_t value) {
  return value >= 0 && value < no_limit_group ? static_cast<std::uint32_t>(value) : no_limit_group;
}

Limit limit_from(const nb::object& row, std::size_t index) {
  if (!nb::hasattr(row, "__getitem__") || !nb::hasattr(row, "__len__"))
    refuse(index, nb::repr(row).c_str());
  const std::size_t size = nb::len(row);
  if (size < 4 || size > 7) refuse(index, (std::to_string(size) + " values").c_str());
  return {index_from(value_at<std::int64_t>(row, 0, index, -1)),
          index_from(value_at<std::int64_t>(row, 1, index, -1)),
          value_at(row, 2, index, 0.0),
          value_at(row, 3, index, 0.0),
          find_limit_kind(value_at<std::string>(row, 4, index, "given")),
          value_at(row, 5, index, 0.0),
          index_from(value_at<std::int64_t>(row, 6, index, -1))};
}

}  // namespace

std::vector<Limit> limits_from(nb::handle rows) {
  std::vector<Limit> limits;
  for (nb::handle row : rows) limits.push_back(limit_from(nb::borrow(row), limits.size()));
  return limits;
}

nb::object limits_to_python(std::span<const Limit> limits) {
  nb::list rows;
  for (const Limit& limit : limits) {
    const std::int64_t group = limit.group == no_limit_group ? -1 : std::int64_t{limit.group};
    rows.append(nb::make_tuple(limit.a, limit.b, limit.least, limit.most,
                               std::string(name(limit.kind)), limit.energy, group));
  }
  nb::list fields;
  for (const auto& [field, type] : {std::pair("a", "u4"),
                                    {"b", "u4"},
                                    {"least", "f8"},
                                    {"most", "f8"},
                                    {"kind", "U16"},
                                    {"energy", "f8"},
                                    {"group", "i8"}})
    fields.append(nb::make_tuple(field, type));
  return nb::module_::import_("numpy").attr("array")(rows, "dtype"_a = fields);
}

}  // namespace pliant::python
