// SPDX-License-Identifier: MIT
// Attributes and keyword arguments from rows of a table of options.
#pragma once

#include <string>
#include <string_view>

#include "bind.hpp"
#include "pliant/base/option_fields.hpp"

namespace pliant::python {

/// "int" for a whole number.
const char* python_type(OptionPlace place);

/// "Sweeps after which a step is given up."
std::string docstring(std::string_view summary);

nb::object value_of(OptionPlace place);

/// Sets an option from a Python value. Raises TypeError or OptionError naming the option if the
/// value does not fit. Ranges are checked by check(), not here.
void take_value(const OptionFacts& facts, OptionPlace place, nb::handle value);

/// "seed: int = 0", as in a signature.
std::string argument_text(const OptionFacts& facts, OptionPlace place);

/// Its lines under "Parameters" in a docstring.
std::string argument_doc(const OptionFacts& facts, OptionPlace place);

/// Raises OptionError if `given` has a name of an earlier version.
void refuse_former(const OptionFacts& facts, nb::dict given);

/// Raises TypeError if an unknown argument is left. `first` is the argument before the named ones.
void refuse_unknown(const char* function, nb::handle first, nb::dict left);

/// Takes from `given` the options of the table that scripts may set, and leaves the others. Raises
/// as refuse_former() and take_value() do.
template <class Fields, class Options>
void take_values(const Fields& fields, nb::dict given, Options& options) {
  for (const auto& field : fields) {
    refuse_former(field, given);
    const nb::str name(field.name.data(), field.name.size());
    if (!field.users.python || !given.contains(name)) continue;
    take_value(field, field.place(options), given[name]);
    nb::del(given[name]);
  }
}

}  // namespace pliant::python
