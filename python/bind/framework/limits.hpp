// SPDX-License-Identifier: MIT
// Limits as arguments and results: rows (a, b, least, most, kind, energy, group), of which the last
// three are optional, and the array of such rows.
#pragma once

#include <nanobind/stl/pair.h>

#include <span>
#include <vector>

#include "bind.hpp"
#include "pliant/framework/framework.hpp"

namespace pliant::python {

/// Reads limits from a sequence of rows or from the array that limits_to_python returns. Throws
/// TypeError for an invalid row, OptionError for an unknown kind.
std::vector<Limit> limits_from(nb::handle rows);

/// A numpy array with fields a, b, least, most, kind, energy, group (-1: none).
nb::object limits_to_python(std::span<const Limit> limits);

/// Adds the limits and overlaps of a summary as attributes of its class.
template <class Summary, class Class>
void bind_violations(Class& summary) {
  summary
      .def_ro("max_limit", &Summary::max_limit,
              "Largest distance of a limit outside its interval, Angstrom.")
      .def_ro("worst_limit", &Summary::worst_limit, "The limit of max_limit.")
      .def_ro("max_overlap", &Summary::max_overlap,
              "How much nearer two joints are than sterics allow, at most, Angstrom.")
      .def_prop_ro(
          "worst_overlap",
          [](const Summary& self) { return std::pair(self.worst_overlap.a, self.worst_overlap.b); },
          "The two joints of max_overlap.");
}

}  // namespace pliant::python
