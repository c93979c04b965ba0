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

/// Whether None leaves the default; a text takes it itself.
bool may_be_none(const OptionFacts& facts, OptionPlace place);

/// Sets an option from a Python value. Raises TypeError or OptionError naming the option if the
/// value does not fit. Ranges are checked by check(), not here.
void take_value(const OptionFacts& facts, OptionPlace place, nb::handle value);

/// "typing.Literal['a', 'b']".
std::string literal_type(const std::vector<std::string_view>& names);

/// "seed: int = 0", as in a signature; "threads: int | None = None" where the default is a choice.
std::string argument_text(const OptionFacts& facts, OptionPlace place);

/// Its lines under "Parameters" in a docstring.
std::string argument_doc(const OptionFacts& facts, OptionPlace place);

/// Raises TypeError where an argument is left that the function has not. `positional` are those
/// before the named ones; of a method the first is None.
void refuse_unknown(nb::handle function, nb::tuple positional, nb::dict left);

/// A row of a table for commands that are written in Python: name, type, default, help, and what
/// there is of choices, least and most.
nb::dict row_of(const OptionFacts& facts, OptionPlace place);

/// All rows of a table.
template <class Fields, class Options>
nb::list rows_for_commands(const Fields& fields, Options usual) {
  nb::list rows;
  for (const auto& field : fields) rows.append(row_of(field, field.place(usual)));
  return rows;
}

/// Parameters of a file from values by their paths. Raises OptionError for any other value.
std::vector<NamedParameter> parameters_from(const nb::dict& values);

/// Parameters of a file by their paths.
nb::dict parameters_to_python(const std::vector<NamedParameter>& parameters);

/// The attribute of an option, which is only read; of a class that has those of the table.
template <class Bound, class Options>
void bind_value(nb::class_<Bound>& to, const OptionField<Options>& field) {
  Options any;
  const std::string name(field.name);
  const std::string getter = "def " + name + "(self) -> " + python_type(field.place(any));
  to.def_prop_ro(
      name.c_str(), [&field](Bound& self) { return value_of(field.place(self)); },
      nb::for_getter(nb::sig(getter.c_str())), docstring(field.summary).c_str());
}

/// Text of all that is open to scripts: "atoms: str = 'CA', step: float = 0.2".
template <class Fields, class Options>
std::string argument_texts(const Fields& fields, Options usual) {
  std::string text;
  for (const auto& field : fields)
    if (field.users.python)
      text += (text.empty() ? "" : ", ") + argument_text(field, field.place(usual));
  return text;
}

/// Their lines in a docstring.
template <class Fields, class Options>
std::string argument_docs(const Fields& fields, Options usual) {
  std::string text;
  for (const auto& field : fields)
    if (field.users.python) text += argument_doc(field, field.place(usual));
  return text;
}

/// Takes from `given` the options of the table that scripts may set, or commands too, and leaves
/// the others. Raises as take_value() does.
template <class Fields, class Options>
void take_values(const Fields& fields, nb::dict given, Options& options,
                 bool is_of_command = false) {
  for (const auto& field : fields) {
    const nb::str name(field.name.data(), field.name.size());
    const bool is_open_to = field.users.python || (is_of_command && field.users.command);
    if (!is_open_to || !given.contains(name)) continue;
    const bool is_open = may_be_none(field, field.place(options)) && given[name].is_none();
    if (!is_open) take_value(field, field.place(options), given[name]);
    nb::del(given[name]);
  }
}

}  // namespace pliant::python
