// SPDX-License-Identifier: MIT
// The run: its options, its summary, and the loop with Python observers.
#include "pliant/run/run.hpp"

#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/variant.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "arrays.hpp"
#include "interrupt.hpp"
#include "messages.hpp"
#include "option_fields.hpp"
#include "options.hpp"
#include "pliant/framework/fingerprint.hpp"
#include "pliant/jobs/files/force_recorder.hpp"
#include "pliant/molecule/structure/structure.hpp"
#include "pliant/run/run_fields.hpp"
#include "refusals.hpp"
#include "run/observers.hpp"
#include "run/pushes.hpp"

namespace pliant::python {
namespace {

/// A State that a run moves; no other run may move it meanwhile. Made and ended with the GIL held.
class StateInUse {
 public:
  explicit StateInUse(const State& state) : state_(&state) {
    if (!all().insert(state_).second) throw std::runtime_error("State: another run is moving it");
  }
  ~StateInUse() { all().erase(state_); }
  StateInUse(const StateInUse&) = delete;
  StateInUse& operator=(const StateInUse&) = delete;

 private:
  static std::set<const State*>& all() {
    static std::set<const State*> states;
    return states;
  }
  const State* state_;
};

/// What a later run goes on from. Needs no GIL.
void end_runs(const std::vector<LockedRecorder*>& recorders, const State& state) {
  for (LockedRecorder* shared : recorders)
    shared->use([&](H5mdRecorder& recorder) { recorder.end_run(state); });
}

/// Whether all frames of a run take no more than so many bytes.
bool are_kept(const Framework& framework, const RunOptions& options, std::int64_t most) {
  const auto bytes = static_cast<std::int64_t>(framework.joint_count() * sizeof(Vec3));
  const std::int64_t frames = options.steps / std::max<std::int64_t>(options.every, 1) + 2;
  return bytes > 0 && frames <= most / bytes;
}

OwnedRunSummary run_steps(const Framework& framework, nb::handle_t<State> state, RunOptions options,
                          const std::vector<nb::object>& observers, ForceRecorder* forces,
                          std::int64_t most_kept) {
  check_pushes(framework, options.replay);
  show_framework(options.technique, framework);
  const StateInUse in_use(nb::cast<const State&>(state));
  std::int64_t done = options.began.value_or(0);
  InterruptWatch watch("steps", options.steps);
  if (forces) options.on_push = [forces](const Push& push) { forces->record(push); };
  options.log = python_log();
  options.resolve.should_stop = [&] { return watch(done); };
  options.onlooker.wants = [&done](std::int64_t step) {
    done = step;
    return false;
  };
  std::vector<Observer> all;
  std::vector<LockedRecorder*> recorders;
  for (const nb::object& observer : observers) {
    all.push_back(observer_of(observer, state));
    if (nb::isinstance<LockedRecorder>(observer))
      recorders.push_back(&nb::cast<LockedRecorder&>(observer));
  }
  std::vector<Vec3> kept;
  const bool keep = are_kept(framework, options, most_kept);
  all.push_back([&](const Frame& frame) {
    if (keep) kept.insert(kept.end(), frame.positions.begin(), frame.positions.end());
    return watch(done);
  });
  RunSummary summary;
  {
    State& moved = nb::cast<State&>(state);
    const nb::gil_scoped_release no_gil;
    summary = run(framework, moved, options, all);
    if (forces) forces->publish();
    end_runs(recorders, moved);
  }
  if (watch.raised()) std::rethrow_exception(watch.raised());
  return {summary, nb::borrow(state), std::move(kept)};
}

/// The attribute of one row of the table of options.
void bind_field(nb::class_<RunOptions>& options, const RunField& field) {
  RunOptions any;
  const std::string name(field.name), type = python_type(field.place(any));
  options.def_prop_rw(
      name.c_str(), [&field](RunOptions& self) { return value_of(field.place(self)); },
      [&field](RunOptions& self, nb::handle value) { take_value(field, field.place(self), value); },
      nb::for_getter(nb::sig(("def " + name + "(self) -> " + type).c_str())),
      nb::for_setter(nb::sig(("def " + name + "(self, arg: " + type + ", /) -> None").c_str())),
      nb::for_setter(nb::arg().none()), docstring(field.summary).c_str());
}

/// Its name, to which a function may be set: ``custom`` from then on.
void bind_technique(nb::class_<RunOptions>& options) {
  options.def_prop_rw(
      "technique", [](const RunOptions& self) { return self.technique.name; },
      [](RunOptions& self, const TechniqueLike& chosen) { choose(self.technique, chosen); },
      nb::for_setter(nb::sig("def technique(self, technique: str | "
                             "collections.abc.Callable[[numpy.typing.NDArray[numpy.float64], int, "
                             "Framework], None], /) -> None")),
      docstring(find_run_field("technique").summary).c_str());
}

void bind_ordering(nb::class_<RunOptions>& options) {
  options.def_prop_rw(
      "ordering",
      [](const RunOptions& self) -> nb::object {
        if (!self.technique.ordering) return nb::none();
        return ordering_to_python(*self.technique.ordering);
      },
      [](RunOptions& self, const std::optional<OrderingColumns>& columns) {
        self.technique.ordering = technique_ordering(columns);
      },
      nb::for_getter(nb::sig("def ordering(self) -> tuple[numpy.typing.NDArray[numpy.uint32], "
                             "numpy.typing.NDArray[numpy.uint32], "
                             "numpy.typing.NDArray[numpy.bool_]] | None")),
      nb::arg().none(),
      "The ordering for technique \"input\", in place of the order of the bars: (bar, near, "
      "is_tree).");
}

void bind_replay(nb::class_<RunOptions>& options) {
  options.def_prop_rw(
      "replay", [](const RunOptions& self) { return pushes_to_python(self.replay); },
      [](RunOptions& self, const PythonPushes& pushes) { self.replay = pushes_from(pushes); },
      "Forces in place of ``perturb``: (joint, (x, y, z)) in kJ/(mol Angstrom), one per step.");
  options.def_rw("replay_counts", &RunOptions::replay_counts,
                 "Forces of ``replay`` in each step; empty: one.");
  options.def_rw("guide", &RunOptions::guide, "Followed in place of ``perturb``.");
}

void bind_options(nb::module_& module) {
  nb::class_<RunOptions> options(module, "RunOptions", "What a run does; checked at its start.");
  options.def(nb::init<>())
      .def(
          "check", [](const RunOptions& self) { check(self); },
          "Raises OptionError naming the option, its value and its range.");
  for (const RunField& field : run_fields())
    if (field.name == "technique")
      bind_technique(options);
    else
      bind_field(options, field);
  options.def_prop_rw(
      "walker", [](const RunOptions& self) { return self.resolve.walker; },
      [](RunOptions& self, nb::handle value) {
        self.resolve.walker = argument_as<std::uint64_t>("walker", value, "int");
      },
      nb::for_setter(nb::sig("def walker(self, arg: int, /) -> None")),
      nb::for_setter(nb::arg().none()), "Which of several independent runs this is.");
  options.def(
      "parameters",
      [](const RunOptions& self, const Framework& framework) {
        return parameters_to_python(parameters_of(self, framework));
      },
      "framework"_a,
      nb::sig("def parameters(self, framework: Framework) -> dict[str, bool | int | float | str]"),
      "Every option by its path below /parameters of a recorded file: \"run/max_sweeps\".");
  bind_ordering(options);
  bind_replay(options);
}

void bind_force_recorder(nb::module_& module) {
  nb::class_<ForceRecorder>(module, "ForceRecorder", "A force file that ``run_steps`` writes.")
      .def(
          "__init__",
          [](ForceRecorder* self, const std::filesystem::path& path, const Framework& framework,
             const RunOptions& options, bool overwrite, const Structure* structure,
             const State* start, const std::vector<std::pair<std::string, std::string>>& input) {
            ForceHeader header = force_header_of(framework);
            if (structure != nullptr && start != nullptr)
              header.structure = fingerprint(structure->atoms, start->positions);
            for (const auto& [name, value] : input) header.input.push_back({name, value});
            new (self) ForceRecorder(path, overwrite, framework,
                                     force_file_of(options, std::move(header)));
          },
          "path"_a, "framework"_a, "options"_a, "overwrite"_a = false, nb::kw_only(),
          "structure"_a = nb::none(), "start"_a = nb::none(),
          "input"_a = std::vector<std::pair<std::string, std::string>>(), nb::keep_alive<1, 3>(),
          "There once the run has ended; ``structure``, where it starts and how its framework was\n"
          "made are noted in it. Raises FileError if it cannot be made.");
}

void bind_kept(nb::class_<OwnedRunSummary>& summary) {
  summary
      .def(
          "__init__",
          [](OwnedRunSummary* self, OwnedRunSummary& other) {
            new (self) OwnedRunSummary(std::move(other));
          },
          "other"_a, "Takes what ``other`` holds.")
      .def_prop_ro(
          "kept",
          [](nb::handle_t<OwnedRunSummary> self) {
            return view_of(nb::cast<OwnedRunSummary&>(self).kept, self);
          },
          "(F * N, 3) float64 view, Angstrom: frames that were kept in memory.");
}

void bind_run_summary(nb::module_& module) {
  nb::class_<OwnedRunSummary> summary(module, "RunSummary", "What a run did.");
  bind_kept(summary);
  summary
      .def_ro("state", &OwnedRunSummary::state, nb::sig("def state(self) -> State"),
              "What the run moved: its last positions.")
      .def_ro("steps", &RunSummary::steps, "Steps done.")
      .def_ro("frames", &RunSummary::frames, "Frames shown to observers.")
      .def_ro("unconverged_steps", &RunSummary::unconverged_steps,
              "Steps after which some bar missed the tolerance.")
      .def_ro("first_unconverged_step", &RunSummary::first_unconverged_step,
              "The first of them; -1 if none.")
      .def_ro("sweeps", &RunSummary::sweeps, "Sweeps of all steps.")
      .def_ro("max_sweeps", &RunSummary::max_sweeps, "Sweeps of the step that needed most.")
      .def_ro("projections", &RunSummary::projections, "Bars looked at in all steps.")
      .def_ro("worst_residual", &RunSummary::worst_residual,
              "Largest |length - rest| / rest after any step.")
      .def_ro("worst_bar", &RunSummary::worst_bar, "Its bar.")
      .def_ro("worst_step", &RunSummary::worst_step, "Its step.")
      .def_ro("stopped_by_caller", &RunSummary::stopped_by_caller, "An observer asked to stop.")
      .def_ro("perturb_seconds", &RunSummary::perturb_seconds, "Wall time of perturbing.")
      .def_ro("resolve_seconds", &RunSummary::resolve_seconds, "Wall time of resolving.")
      .def_ro("observe_seconds", &RunSummary::observe_seconds, "Wall time of the observers.")
      .def_ro("seconds", &RunSummary::seconds, "Wall time of it all.")
      .def_prop_ro(
          "converged", [](const OwnedRunSummary& self) { return self.unconverged_steps == 0; },
          "Every bar was within the tolerance after every step.")
      .def_prop_ro(
          "mean_sweeps", [](const OwnedRunSummary& self) { return self.mean_sweeps(); },
          "Mean number of sweeps a step.")
      .def_prop_ro(
          "ns_per_bar_and_sweep",
          [](const OwnedRunSummary& self) { return self.ns_per_bar_and_sweep(); },
          "Resolve time over projections, nanoseconds.")
      .def("__repr__", [](const OwnedRunSummary& self) {
        return "<pliant.RunSummary: " + std::to_string(self.steps) + " steps, " +
               std::to_string(self.frames) + " frames, " + std::to_string(self.unconverged_steps) +
               " unconverged>";
      });
}

}  // namespace

void bind_run(nb::module_& module) {
  bind_options(module);
  bind_force_recorder(module);
  bind_run_summary(module);
  module.def(
      "run_steps", &run_steps, "framework"_a, "state"_a, "options"_a, "observers"_a,
      "forces"_a = nb::none(), "most_kept"_a = 0,
      "Steps ``state`` on and shows frames to observers; the function ``run`` says more. Frames\n"
      "that take at most ``most_kept`` bytes in all are kept in memory.");
}

}  // namespace pliant::python
