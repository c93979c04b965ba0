// SPDX-License-Identifier: MIT
// Recording: frames to H5MD files.
#include <nanobind/stl/filesystem.h>

#include "framework/frame.hpp"
#include "locked.hpp"
#include "messages.hpp"
#include "option_fields.hpp"
#include "pliant/base/error.hpp"
#include "pliant/base/version.hpp"
#include "pliant/jobs/files/molecule_header.hpp"
#include "pliant/molecule/selection.hpp"
#include "pliant/molecule/structure/structure.hpp"

namespace pliant::python {

void bind_h5md_reader(nb::module_& module);
void bind_topology(nb::module_& module);

namespace {

void make_recorder(LockedRecorder* self, const std::filesystem::path& path,
                   const Framework& framework, const Structure* structure,
                   const nb::dict& parameters, double precision, const std::string& save,
                   bool overwrite, double flush_seconds) {
  H5mdHeader header = structure != nullptr ? molecule_header(*structure) : H5mdHeader();
  header.creator_version = version();
  header.parameters = parameters_from(parameters);
  const H5mdOptions options{.precision = precision,
                            .saved = select_joints(framework, save, "save"),
                            .overwrite = overwrite,
                            .flush_seconds = flush_seconds,
                            .log = unraisable_python_log()};
  const nb::gil_scoped_release no_gil;
  new (self) LockedRecorder(path, framework, header, options);
}

void record(LockedRecorder& self, const OwnedFrame& frame) {
  Frame shown = frame.frame;
  shown.previous = {};  // which nothing keeps alive
  shown.limits_off = {};
  self.call([&](H5mdRecorder& recorder) { recorder.record(shown); });
}

constexpr const char* recorder_doc =
    R"(Writes frames to an H5MD 1.1 file (de Buyl, Colberg, Hoefling, Comput. Phys. Commun. 185 (2014) 1546).

The file opens in MDAnalysis, h5py and every other HDF5 program, while it is written and after its
writer was killed, with every frame committed until then. An observer of ``run``, and a context
manager that closes itself; the file of ``run(..., output=)`` can go on, too.

Parameters
----------
path : str or path
    Appears with the first frame.
framework : Framework
    Its bars, rest lengths and atom names are recorded.
structure : Structure, optional
    Its bonds and masses are recorded too.
parameters : dict of str to bool, int, float or str
    Values below /parameters, by path: ``{"run/seed": 5}``.
precision : float
    Round positions, by half of this at most (Angstrom), and compress them; 0: do not round.
save : str
    Selection of the atoms to record; empty: all. The file then has no others, and no run goes on
    from it.
overwrite : bool
    Replace an existing file.
flush_seconds : float
    Seconds between commits of frames; 0: commit each frame.

Raises
------
FileError
    The file exists, cannot be written, or is being written by another recorder.
OptionError
    A bad option or path of a parameter.
)";

}  // namespace

void bind_record(nb::module_& module) {
  bind_h5md_reader(module);
  bind_topology(module);
  nb::class_<LockedRecorder>(module, "H5mdRecorder", recorder_doc)
      .def("__init__", &make_recorder, "path"_a, "framework"_a, nb::kw_only(),
           "structure"_a = nb::none(), "parameters"_a = nb::dict(), "precision"_a = 0.0,
           "save"_a = "", "overwrite"_a = false, "flush_seconds"_a = 1.0)
      .def("record", &record, "frame"_a,
           "Adds a frame, which must come after the last one and have finite positions and time.\n"
           "Raises FileError once the recorder is closed.")
      .def("__call__", &record, "frame"_a, "The same, so that it is an observer.")
      .def("flush", locked<H5mdRecorder, &H5mdRecorder::flush>(),
           "Commits all recorded frames, which then survive this process.")
      .def("close", locked<H5mdRecorder, &H5mdRecorder::close>(),
           "Commits and closes; further calls do nothing.")
      .def_prop_ro("frames", locked<H5mdRecorder, &H5mdRecorder::frames>(), "Frames recorded.")
      .def_prop_ro("committed_frames", locked<H5mdRecorder, &H5mdRecorder::committed_frames>(),
                   "Frames recorded and certain to be in the file.")
      .def_prop_ro(
          "path",
          [](LockedRecorder& self) {
            return self.call([](H5mdRecorder& recorder) { return recorder.path(); });
          },
          "Where the file is.")
      .def(
          "__enter__", [](nb::handle_t<LockedRecorder> self) { return nb::borrow(self); },
          nb::sig("def __enter__(self) -> H5mdRecorder"))
      .def(
          "__exit__",
          [](LockedRecorder& self, const nb::args&) {
            locked<H5mdRecorder, &H5mdRecorder::close>()(self);
          },
          nb::sig("def __exit__(self, *exception: object) -> None"));
}

}  // namespace pliant::python
