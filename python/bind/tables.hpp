// SPDX-License-Identifier: MIT
// Tables of named things: each row becomes an object that refers to the library's table.
#pragma once

#include <span>

#include "bind.hpp"

namespace pliant::python {

/// A class for the rows of a table, with `name` and `summary`.
template <class Row>
nb::class_<Row> bind_row(nb::module_& module, const char* name, const char* doc) {
  nb::class_<Row> row(module, name, doc);
  row.def_ro("name", &Row::name, "What options call it.");
  row.def_ro("summary", &Row::summary, "What it does, in one line.");
  const std::string text = std::string("<pliant.") + name + ": ";
  row.def("__repr__", [text](const Row& self) { return text + std::string(self.name) + ">"; });
  return row;
}

/// The rows of a table, which must live as long as the process.
template <class Row>
std::vector<const Row*> rows_of(std::span<const Row> table) {
  std::vector<const Row*> rows;
  for (const Row& row : table) rows.push_back(&row);
  return rows;
}

}  // namespace pliant::python
