// SPDX-License-Identifier: MIT
// A job `run` from the arguments of a call: rows of tables, and what only scripts can give.
#pragma once

#include <string>
#include <vector>

#include "bind.hpp"
#include "pliant/jobs/job.hpp"

namespace pliant::python {

/// "steps: int = 1000, every: int = 1, ...": how walkers move.
std::string argument_texts_of_moves();
/// Their lines in a docstring.
std::string argument_docs_of_moves();

/// Takes how walkers move: rows, replay, guide, ordering. Raises as take_values() does.
void take_moves(nb::dict given, Job& job);

/// Takes an argument away from `given`; None where it is not there.
nb::object taken(nb::dict given, const char* name);

/// The members of what is iterated over. Raises TypeError naming the argument.
std::vector<nb::object> members_of(const char* name, nb::handle value);

/// What is run: objects of Python.
struct AskedRun {
  nb::object framework, structure, state;  ///< structure: None where nothing is known of it
  bool is_given = false;                   ///< the framework was not made here

  const Framework& of() const { return nb::cast<const Framework&>(framework); }
  State& start() const { return nb::cast<State&>(state); }
  const Structure* molecule() const;
};

/// Makes the framework of a structure or a file, as the job says. Raises TypeError and as the
/// readers do.
AskedRun open_run(nb::handle source, nb::object state, nb::object structure, Job& job);

}  // namespace pliant::python
