// SPDX-License-Identifier: MIT
// Paths between two structures of a molecule: the matched ends, the walk, and its table.
#include "pliant/path/path.hpp"

#include <nanobind/stl/shared_ptr.h>

#include <atomic>

#include "arrays.hpp"
#include "interrupt.hpp"
#include "locked.hpp"
#include "messages.hpp"
#include "path/asked_path.hpp"
#include "path/trace.hpp"
#include "pliant/base/number.hpp"

namespace pliant::python {
namespace {

/// A walk that Ctrl-C stops.
class PythonPathWalk {
 public:
  PythonPathWalk(std::shared_ptr<PathEnds> ends, PathOptions options)
      : ends_(std::move(ends)), walk_(ends_, watched(std::move(options))) {}

  bool advance() {
    const Use use(in_use_);
    watch_ = InterruptWatch();
    bool goes_on = false;
    {
      const nb::gil_scoped_release no_gil;
      goes_on = walk_.advance();
    }
    if (watch_.raised()) std::rethrow_exception(watch_.raised());
    return goes_on;
  }

  /// Looks at the walk while no step is under way. Gives up the GIL.
  template <class Look>
  auto look(Look&& at) {
    const Use use(in_use_);
    const nb::gil_scoped_release no_gil;
    return at(walk_);
  }

  const std::shared_ptr<PathEnds>& ends() const { return ends_; }

 private:
  /// One call at a time.
  class Use {
   public:
    explicit Use(std::atomic<bool>& in_use) : in_use_(in_use) {
      if (in_use_.exchange(true)) throw std::runtime_error("PathWalk: a step is under way");
    }
    ~Use() { in_use_ = false; }
    Use(const Use&) = delete;
    Use& operator=(const Use&) = delete;

   private:
    std::atomic<bool>& in_use_;
  };

  PathOptions watched(PathOptions options) {
    options.should_stop = [this] { return watch_(); };
    return options;
  }

  std::shared_ptr<PathEnds> ends_;
  InterruptWatch watch_;
  std::atomic<bool> in_use_{false};
  PathWalk walk_;
};

std::shared_ptr<PathEnds> matched(const Structure& start, const Structure& end, AskedPath options) {
  options.model.log = python_log();
  const nb::gil_scoped_release no_gil;
  return std::make_shared<PathEnds>(match_ends(start, end, options));
}

std::shared_ptr<PathEnds> ends_at_places(const Structure& start, const ArrayLike& atoms,
                                         const ArrayLike& goal, AskedPath options,
                                         const OptionalArray& from) {
  std::vector<std::uint32_t> asked;
  for (const std::int64_t atom : integers_from(atoms, "atoms"))
    asked.push_back(static_cast<std::uint32_t>(atom));
  std::vector<Vec3> places = positions_from(goal, "goal"), begun;
  if (from) begun = positions_from(*from, "begun");
  options.model.log = options.model.prepare.log = {};  // model_of() has said it
  const nb::gil_scoped_release no_gil;
  return std::make_shared<PathEnds>(
      ends_at(start, std::move(asked), std::move(places), options, std::move(begun)));
}

MolecularModel model_to_move(const Structure& start, AskedPath options) {
  options.model.log = python_log();
  const nb::gil_scoped_release no_gil;
  return model_of_start(start, options.model);
}

/// (F, N, 3) of the frames from one on.
FramesView path_positions(PythonPathWalk& self, std::size_t first) {
  std::vector<Vec3> all;
  const std::size_t joints = self.ends()->start.model.positions.size();
  const std::size_t count = self.look([&](const PathWalk& walk) {
    for (std::size_t k = first; k < walk.frame_count(); ++k) {
      const auto positions = walk.frame(k).positions;
      all.insert(all.end(), positions.begin(), positions.end());
    }
    return walk.frame_count() - std::min(first, walk.frame_count());
  });
  return new_frames(std::move(all), count, joints);
}

void record_walk(PythonPathWalk& self, LockedRecorder& recorder) {
  self.look([&](const PathWalk& walk) {
    recorder.use([&](H5mdRecorder& file) {
      for (std::size_t k = 0; k < walk.frame_count(); ++k) file.record(walk.frame(k));
    });
  });
}

constexpr const char* ends_doc =
    R"(Two structures of one molecule, matched: residues, atoms and contacts that both have.

Residues are matched as ``match_residues`` does, ligands and metals by chain, number and name. Models
are those of ``build_model``, with the contacts that both structures have; contacts of what is not
matched are dropped, and not counted.

Parameters
----------
start, end : Structure
    With their bonds, as ``read`` gives them.
options : PathOptions

Raises
------
InputError
    They do not match, or have no residues of proteins or nucleic acids.
)";

void bind_ends(nb::module_& module) {
  nb::class_<PathEnds>(module, "PathEnds", ends_doc)
      .def(nb::new_(&matched), "start"_a, "end"_a, "options"_a = AskedPath())
      .def_static(
          "at", &ends_at_places, "start"_a, "atoms"_a, "goal"_a, "options"_a = AskedPath(),
          "begun"_a.none() = nb::none(),
          "Ends whose goal (K, 3) is that of atoms (K) of the start's model: CA, P. The walk "
          "begins at\nanother frame (N, 3) of the model, if one is given.")
      .def_static("model_of", &model_to_move, "start"_a, "options"_a = AskedPath(),
                  "The model that a start moves as, with all contacts that are found.")
      .def_prop_ro(
          "model", [](const PathEnds& self) -> const MolecularModel& { return self.start.model; },
          nb::rv_policy::reference_internal,
          "MolecularModel of the start, with the contacts that both have.")
      .def_prop_ro(
          "asked", [](const PathEnds& self) { return array_of(self.start.asked); },
          nb::rv_policy::reference, "(K,) uint32: atoms of the model that are asked to arrive.")
      .def_prop_ro(
          "goal", [](const PathEnds& self) { return new_positions(self.goal); },
          nb::rv_policy::reference, "(K, 3) float64: where the end has them, Angstrom.")
      .def_ro("matched", &PathEnds::matched, "Residues.")
      .def_prop_ro(
          "only_start", [](const PathEnds& self) { return self.to_lose.size(); },
          "Contacts that only the start has.")
      .def_ro("only_end", &PathEnds::end_contacts, "Contacts that only the end has.")
      .def_ro("source_of_end", &PathEnds::source_of_end, "Its file.")
      .def_ro("notes", &PathEnds::notes, "How residues were matched, line by line.");
}

constexpr const char* walk_doc =
    R"(A path as it is found, step by step.

At each step the end is superposed on the molecule, whose residues are asked to go towards it by a
fixed r.m.s. distance; technique ``froda`` then makes bars whole, keeps atoms apart and holds the
contacts that both structures have (targeting: S. Wells et al., Phys. Biol. 2 (2005) S127; D. W.
Farrell, K. Speranskiy, M. F. Thorpe, Proteins 78 (2010) 2908). The same ends, options and seed give
the same bits. Two calls at once raise RuntimeError.

Parameters
----------
ends : PathEnds
    Matched with the same options.
options : PathOptions
)";

template <class Result>
auto looking(Result (PathWalk::*at)() const) {
  return [at](PythonPathWalk& self) {
    return self.look([&](const PathWalk& walk) { return (walk.*at)(); });
  };
}

void bind_walk(nb::module_& module) {
  nb::class_<PythonPathWalk>(module, "PathWalk", walk_doc)
      .def(nb::init<std::shared_ptr<PathEnds>, AskedPath>(), "ends"_a, "options"_a = AskedPath())
      .def(
          "advance", &PythonPathWalk::advance,
          "One step at most, of either molecule. False once the walk has ended. Releases the GIL;\n"
          "Ctrl-C takes the step back.")
      .def_prop_ro("is_over", looking(&PathWalk::is_over), "Whether it has ended.")
      .def_prop_ro("left", looking(&PathWalk::left),
                   "How far the last frame is from the end, Angstrom.")
      .def_prop_ro("attempts", looking(&PathWalk::attempts), "Number of detours tried.")
      .def_prop_ro("turned", looking(&PathWalk::turned),
                   "Degrees: the largest turn of a piece of the molecule that the way was guessed "
                   "with; 0 where it is straight.")
      .def_prop_ro("notes", looking(&PathWalk::notes),
                   "How residues were matched, where the ends met, why it ended.")
      .def("__len__", looking(&PathWalk::frame_count))
      .def("positions", &path_positions, "first"_a = 0, nb::rv_policy::reference,
           "(F, N, 3) float64: frames of the start on the best way so far, from one on, Angstrom.")
      .def(
          "table",
          [](PythonPathWalk& self) {
            return self.look([&](const PathWalk& walk) { return table_of(walk); });
          },
          "The table of these frames: a PathFrame for each.")
      .def("record", &record_walk, "recorder"_a, "Writes these frames to an H5mdRecorder.");
}

void bind_table(nb::module_& module) {
  nb::class_<PathFrame>(module, "PathFrame", "One step of a path.")
      .def("__repr__",
           [](const PathFrame& self) {
             return "<pliant.PathFrame " + std::to_string(self.step) + ": " +
                    number_text(self.to_end, 3) + " Angstrom from the end>";
           })
      .def_ro("step", &PathFrame::step, "Number of the step, from 0.")
      .def_ro("to_end", &PathFrame::to_end,
              "r.m.s. distance of the matched atoms from the end, superposed, Angstrom.")
      .def_ro("from_start", &PathFrame::from_start, "The same from the start.")
      .def_ro("lost", &PathFrame::lost,
              "Contacts that only the start has, and that are broken here.")
      .def_ro("made", &PathFrame::made, "Contacts that only the end has, and that are there.")
      .def_ro("max_residual", &PathFrame::max_residual, "Worst bar, relative to its length.")
      .def_ro("held_off", &PathFrame::held_off,
              "Largest distance of a shared contact outside its interval, Angstrom.")
      .def_ro("overlap", &PathFrame::overlap,
              "By how much two atoms are nearer than allowed, Angstrom.")
      .def_ro("tightest", &PathFrame::tightest,
              "These two: \"A:LYS12 NZ - A:ASP54 OD1\"; empty if there are none.");
  nb::class_<TightPlace>(module, "TightPlace",
                         "Two atoms too near each other, more than any others in some frames.")
      .def("__repr__",
           [](const TightPlace& self) {
             return "<pliant.TightPlace " + self.atoms + ": " + number_text(self.overlap, 3) +
                    " Angstrom>";
           })
      .def_ro("atoms", &TightPlace::atoms, "\"A:LYS12 NZ - A:ASP54 OD1\".")
      .def_ro("overlap", &TightPlace::overlap,
              "By how much they are nearer than allowed, at most, Angstrom.")
      .def_ro("step", &TightPlace::step, "Step of the largest overlap.")
      .def_ro("frames", &TightPlace::frames,
              "Number of frames in which these two are the tightest.");
  module.def(
      "tight_places",
      [](const std::vector<PathFrame>& frames, std::size_t count) {
        return tight_places(frames, count);
      },
      "frames"_a, "count"_a = 3,
      "Pairs of atoms that are the tightest of a frame, the most overlapping first; ``count`` at\n"
      "most.");
}

}  // namespace

void bind_path(nb::module_& module) {
  bind_trace(module);
  bind_path_options(module);
  bind_ends(module);
  bind_table(module);
  bind_walk(module);
}

}  // namespace pliant::python
