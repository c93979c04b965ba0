// SPDX-License-Identifier: MIT
// Checkpoints: runs in H5MD files, to go on.
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/unique_ptr.h>

#include "locked.hpp"
#include "messages.hpp"
#include "pliant/base/error.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/jobs/files/recorded_run.hpp"
#include "pliant/record/h5md/h5md_checkpoint_reader.hpp"

namespace pliant::python {
namespace {

H5mdCheckpoint opened(const std::filesystem::path& path, std::optional<std::int64_t> steps) {
  const Log log = python_log();
  const nb::gil_scoped_release no_gil;
  H5mdCheckpoint from = read_checkpoint(path, steps, log);
  if (from.is_sample())
    throw InputError(path_text(path) +
                     ": holds frames of sample: continue_sample goes on with them");
  if (from.done > from.steps)
    throw OptionError("steps = " + std::to_string(from.steps) + ": " + path_text(path) + " has " +
                      std::to_string(from.done) + " steps already");
  return from;
}

}  // namespace

void bind_checkpoint(nb::module_& module) {
  nb::class_<H5mdCheckpoint>(module, "Checkpoint",
                             "A run in an H5MD file that can continue; see ``continue_run``.")
      .def_ro("framework", &H5mdCheckpoint::framework, "What the run moves.")
      .def_prop_ro(
          "state", [](const H5mdCheckpoint& self) { return self.state; },
          "A copy of the state to step on from.")
      .def_prop_ro(
          "options", [](const H5mdCheckpoint& self) { return run_options_from(self); },
          "How the run goes on.")
      .def_ro("frames", &H5mdCheckpoint::frames, "Frames of the file that stay.")
      .def_ro("done", &H5mdCheckpoint::done, "Steps done.")
      .def(
          "recorder",
          [](const H5mdCheckpoint& self, double flush_seconds, bool durable) {
            H5mdOptions options;
            options.flush_seconds = flush_seconds;
            options.durable = durable;
            options.log = unraisable_python_log();
            const nb::gil_scoped_release no_gil;
            return std::make_unique<LockedRecorder>(self, options);
          },
          "flush_seconds"_a = 1.0, "durable"_a = false,
          nb::sig("def recorder(self, flush_seconds: float = 1.0, durable: bool = False) -> "
                  "H5mdRecorder"),
          "Opens the file to add frames. Raises FileError if it is being written.");
  module.def(
      "read_checkpoint", &opened, "path"_a, "steps"_a = nb::none(),
      "Reads what the run of a file continues from; ``steps`` is the total number of steps.\n"
      "Raises InputError if the file lacks it.");
}

}  // namespace pliant::python
