// SPDX-License-Identifier: MIT
// Errors, warnings and notes.
#include "bind.hpp"
#include "messages.hpp"
#include "pliant/base/error.hpp"
#include "pliant/base/version.hpp"

namespace pliant::python {
namespace {

constexpr const char* warning_doc =
    "A guess was made or something was left out. The warnings module can filter it.";

nb::object& warning_class() {
  // Kept for the life of the process, as the classes of exceptions are: no order of destruction.
  static auto* kept = new nb::object;
  return *kept;
}

void describe(nb::handle type, const char* text) { type.attr("__doc__") = text; }

bool is_ours(nb::handle frame) {
  const auto name =
      nb::cast<std::string>(nb::str(frame.attr("f_globals").attr("get")("__name__", "")));
  return name == "pliant" || name.starts_with("pliant.");
}

/// How many Python frames up the caller is: functions of the package stand between. A thread of the
/// library has none.
int level_of_caller() {
  if (PyEval_GetFrame() == nullptr) return 1;
  nb::object frame = nb::module_::import_("sys").attr("_getframe")(0);
  int level = 1;
  while (!frame.is_none() && is_ours(frame)) {
    frame = frame.attr("f_back");
    ++level;
  }
  return level;
}

void warn(std::string_view text) {
  const std::string copy(text);
  if (PyErr_WarnEx(warning_class().ptr(), copy.c_str(), level_of_caller()) != 0)
    throw nb::python_error();
}

void note(std::string_view text) {
  nb::module_::import_("logging").attr("getLogger")("pliant").attr("info")(
      "%s", nb::str(text.data(), text.size()));
}

}  // namespace

Log python_log() {
  return {[](Severity severity, std::string_view text) {
    const nb::gil_scoped_acquire gil;
    if (severity == Severity::warning) {
      warn(text);
    } else {
      note(text);
    }
  }};
}

Log unraisable_python_log() {
  return {[log = python_log()](Severity severity, std::string_view text) {
    const nb::gil_scoped_acquire gil;
    try {
      log.function(severity, text);
    } catch (nb::python_error& error) {
      error.restore();
      PyErr_WriteUnraisable(Py_None);
    }
  }};
}

void bind_base(nb::module_& module) {
  module.def("version", &version, "Version of the library.");
  const nb::exception<Error> error(module, "Error");
  describe(error, "Anything that Pliant raises by itself.");
  const nb::handle value_error(PyExc_ValueError), os_error(PyExc_OSError);
  const nb::exception<InputError> input(module, "InputError", nb::make_tuple(error, value_error));
  describe(input,
           "The input is wrong: the message names file, line and field, what was expected and "
           "found.");
  const nb::exception<OptionError> option(module, "OptionError",
                                          nb::make_tuple(error, value_error));
  describe(option, "An option is out of its range or names no known choice.");
  const nb::exception<FileError> file(module, "FileError", nb::make_tuple(error, os_error));
  describe(file,
           "A file could not be opened, read or written; the message ends with the system's "
           "reason.");
  const std::string warning_name =
      nb::cast<std::string>(module.attr("__name__")) + ".PliantWarning";
  warning_class() = nb::steal(
      PyErr_NewExceptionWithDoc(warning_name.c_str(), warning_doc, PyExc_UserWarning, nullptr));
  module.attr("PliantWarning") = warning_class();
}

}  // namespace pliant::python
