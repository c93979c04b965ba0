// SPDX-License-Identifier: MIT
// Files that get their names when they are complete, for pliant.base.new_file.
#include <nanobind/stl/filesystem.h>

#include "bind.hpp"
#include "pliant/text/output_file.hpp"

namespace pliant::python {

void bind_text(nb::module_& module) {
  nb::class_<OutputFile>(
      module, "OutputFile",
      "A new file beside its final name, which no other process writes to meanwhile.\n\n"
      "Raises FileError where `target` exists and `overwrite` is false, is no regular file, is\n"
      "being written, or cannot be written.")
      .def(nb::init<const std::filesystem::path&, bool>(), "target"_a, nb::kw_only(),
           "overwrite"_a = false)
      .def_prop_ro("partial", &OutputFile::partial, "Where it is until it is published.")
      .def_prop_ro("target", &OutputFile::target, "Where it will be.")
      .def(
          "publish", &OutputFile::publish, nb::call_guard<nb::gil_scoped_release>(),
          "Gives the file its final name. Raises FileError as the constructor does, and where the\n"
          "file system has not taken all that was written.")
      .def("close", &OutputFile::close, "Deletes the file unless it was published.");
}

}  // namespace pliant::python
