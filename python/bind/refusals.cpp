// SPDX-License-Identifier: MIT
#include "refusals.hpp"

#include <array>
#include <cstring>

namespace pliant::python {
namespace {

// A function of nanobind begins with what every object of varying size has, then the pointer that
// Python calls. There are a few kinds of them.
constexpr std::size_t most_kinds = 16;
std::array<vectorcallfunc, most_kinds> originals{};

// Python and nanobind keep flags above the number of arguments.
constexpr std::size_t count_bits = 0xffff;

vectorcallfunc& call_of(PyObject* function) {
  return *reinterpret_cast<vectorcallfunc*>(reinterpret_cast<char*>(function) +
                                            sizeof(PyVarObject));
}

/// The arguments by position and by name, as Python functions have them.
nb::tuple arguments_from(bool is_method, PyObject* const* arguments, std::size_t count,
                         PyObject* names) {
  nb::list positional;
  // The object of a method is not looked at; that of __init__ is not made yet.
  for (std::size_t k = 0; k < count; ++k)
    positional.append(is_method && k == 0 ? nb::none() : nb::borrow(arguments[k]));
  nb::dict named;
  const std::size_t name_count = names == nullptr ? 0 : nb::len(nb::handle(names));
  for (std::size_t k = 0; k < name_count; ++k)
    named[nb::handle(names)[k]] = nb::handle(arguments[count + k]);
  return nb::make_tuple(nb::tuple(positional), named);
}

/// Puts a better error in place of "incompatible function arguments"; any other one stays.
void improve_error(PyObject* function, PyObject* const* arguments, std::size_t count,
                   PyObject* names) {
  try {
    nb::python_error error;  // takes the error that is set
    const bool is_unfit = error.matches(PyExc_TypeError) &&
                          std::strstr(error.what(), "incompatible function arguments") != nullptr;
    if (!is_unfit) return error.restore();
    const nb::tuple given =
        arguments_from(nb::handle(function).type().attr("__name__").equal(nb::str("nb_method")),
                       arguments, count, names);
    nb::module_::import_("pliant.base.refusals")
        .attr("refuse_call")(nb::handle(function), given[0], given[1]);
    error.restore();  // where nothing was found that does not fit
  } catch (nb::python_error& better) {
    better.restore();
  }
}

/// What Python calls in place of a function of kind K.
template <std::size_t K>
PyObject* call(PyObject* function, PyObject* const* arguments, std::size_t count, PyObject* names) {
  PyObject* result = originals[K](function, arguments, count, names);
  if (result == nullptr) improve_error(function, arguments, count & count_bits, names);
  return result;
}

template <std::size_t... K>
constexpr std::array<vectorcallfunc, sizeof...(K)> calls_of(std::index_sequence<K...>) {
  return {&call<K>...};
}
constexpr auto calls = calls_of(std::make_index_sequence<most_kinds>());

/// Whether Python calls the function by this pointer. The stable ABI only tells whether by any.
bool is_called_at([[maybe_unused]] vectorcallfunc place, PyObject* function) {
#ifdef Py_LIMITED_API
  return (PyType_GetFlags(Py_TYPE(function)) & Py_TPFLAGS_HAVE_VECTORCALL) != 0;
#else
  return place == PyVectorcall_Function(function);
#endif
}

void name_unfit_arguments_of(PyObject* function) {
  vectorcallfunc& place = call_of(function);
  if (!is_called_at(place, function)) return;  // of another make than we know
  for (std::size_t k = 0; k < most_kinds; ++k) {
    if (place == calls[k]) return;
    if (originals[k] == nullptr) originals[k] = place;
    if (originals[k] != place) continue;
    place = calls[k];
    return;
  }
}

bool is_function(nb::handle thing) {
  const auto type = nb::cast<std::string>(thing.type().attr("__name__"));
  return type == "nb_func" || type == "nb_method";
}

void name_unfit_arguments_in(nb::handle scope) {
  for (nb::handle thing : nb::list(scope.attr("__dict__").attr("values")())) {
    if (is_function(thing)) name_unfit_arguments_of(thing.ptr());
    if (nb::hasattr(thing, "fset") && is_function(thing.attr("fset")))
      name_unfit_arguments_of(thing.attr("fset").ptr());
    if (PyType_Check(thing.ptr()) && !scope.is(thing) &&
        thing.attr("__module__").equal(nb::str("pliant._core")))
      name_unfit_arguments_in(thing);
  }
}

}  // namespace

void refuse_argument(std::string_view name, nb::handle value, const char* type, nb::object least,
                     nb::object most) {
  nb::module_::import_("pliant.base.refusals")
      .attr("refuse")(nb::str(name.data(), name.size()), value, type, least, most);
  throw nb::type_error("an argument does not fit");  // refuse() always raises
}

void name_unfit_arguments(nb::module_& module) { name_unfit_arguments_in(module); }

}  // namespace pliant::python
