// SPDX-License-Identifier: MIT
// The job `run`: one walker, many walkers, and going on.
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/pair.h>

#include <optional>
#include <utility>

#include "messages.hpp"
#include "molecule/structure.hpp"
#include "option_fields.hpp"
#include "pliant/base/choices.hpp"
#include "pliant/base/error.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/framework/fingerprint.hpp"
#include "pliant/jobs/continued_run.hpp"
#include "pliant/jobs/run_job.hpp"
#include "pliant/molecule/structure/structure.hpp"
#include "refusals.hpp"
#include "resolve/techniques.hpp"
#include "run/asked_run.hpp"
#include "run/pushes.hpp"
#include "run/run_watched.hpp"

namespace pliant::python {
namespace {

nb::module_ core() { return nb::module_::import_("pliant._core"); }

const OptionFacts& select_row() { return choose(input_fields(), "option", "select"); }

const OptionFacts& forces_row() { return choose(walkers_fields(), "option", "record_forces"); }

/// The rows of a call of `run`; others are left.
Job take_job(nb::dict given) {
  Job job = usual_job("run");
  take_values(output_fields(), given, job.output);
  if (!job.output.output.empty())
    nb::module_::import_("pliant.base.output_names")
        .attr("check_trajectory_name")(job.output.output, "run");
  if (job.output.topology.empty()) job.output.topology = no_topology;
  take_values(bars_fields(), given, job.molecule.bars);
  take_values(walkers_fields(), given, job.walkers);
  if (given.contains("select"))
    take_value(select_row(), &job.molecule.input.select, taken(given, "select"));
  if (given.contains("walker"))
    job.walkers.first = static_cast<std::int64_t>(
        argument_as<std::uint64_t>("walker", taken(given, "walker"), "int"));
  if (const nb::object value = taken(given, "guide"); !value.is_none())
    job.run.guide = argument_as<Guide>("guide", value, "Guide");
  take_moves(given, job);
  return job;
}

/// Only structures have names and bonds.
void refuse_nameless(const Job& job, const AskedRun& asked) {
  const bool has_names = asked.molecule() != nullptr && asked.of().atoms() != nullptr;
  if (has_names) return;
  if (job.output.topology != no_topology) throw nb::type_error("run: a topology needs a structure");
  if (is_pdb_name(job.output.output))
    throw nb::type_error("run: models of a PDB file need a structure");
}

RunSubject subject_of(const AskedRun& asked, const Job& job) {
  RunSubject subject{asked.of(), asked.start().positions, asked.molecule()};
  subject.is_given = asked.is_given;
  if (subject.structure != nullptr && !job.walkers.record_forces.empty())
    subject.fingerprint = fingerprint(subject.structure->atoms, subject.start);
  return subject;
}

/// As a class of pliant that has methods of frames besides, and is written in Python.
nb::object result_of(OwnedRunSummary made, nb::object structure, const std::string& output) {
  const nb::object path = output.empty() ? nb::none() : nb::cast(path_of(output));
  return nb::module_::import_("pliant.trajectory.results")
      .attr("RunResult")(nb::cast(std::move(made)), structure, path);
}

std::int64_t most_kept(const std::string& output) {
  if (!output.empty() && !is_pdb_name(output)) return 0;
  return nb::cast<std::int64_t>(
      nb::module_::import_("pliant.trajectory.results").attr("MOST_KEPT"));
}

nb::object run_from(const nb::handle& source, nb::object state, const nb::object& output,
                    const nb::kwargs& more) {
  nb::dict given(more);
  if (!output.is_none()) given["output"] = output;
  Job job = take_job(given);
  std::vector<nb::object> observers;
  if (const nb::object value = taken(given, "observers"); !value.is_none())
    observers = members_of("observers", value);
  std::vector<NamedParameter> parameters;
  if (const nb::object value = taken(given, "parameters"); !value.is_none())
    parameters = parameters_from(argument_as<nb::dict>(
        "parameters", value, "collections.abc.Mapping[str, bool | int | float | str]"));
  nb::object structure = taken(given, "structure");
  refuse_unknown(core().attr("run"), nb::make_tuple(source), given);
  if (!structure.is_none() && !nb::isinstance<Structure>(structure))
    refuse_argument("structure", structure, "Structure", nb::none(), nb::none());
  const AskedRun asked = open_run(source, std::move(state), std::move(structure), job);
  refuse_nameless(job, asked);
  check_pushes(asked.of(), job.run.replay);
  show_framework(job.run.technique, asked.of());
  const StateInUse in_use(asked.start());
  RunJob run(std::move(job), "");
  run.take(subject_of(asked, run.job()), python_log(), std::move(parameters));
  const std::string& path = run.job().output.output;
  AloneWatched watched(asked.of(), asked.state, run.job().run, std::move(observers),
                       most_kept(path));
  RunSummary summary;
  {
    const RunWatch watch = watched.watch();
    State& moved = asked.start();
    const nb::gil_scoped_release no_gil;
    summary = run.run_alone(moved, watch);
    watched.end(moved);
  }
  return result_of(watched.summary(summary, asked.state), asked.structure, path);
}

std::pair<std::uint64_t, std::uint64_t> shard_from(nb::handle value) {
  std::pair<std::int64_t, std::int64_t> shard;
  if (nb::try_cast(value, shard) && shard.first >= 0 && shard.second >= 0) return shard;
  throw OptionError(
      "shard = " +
      nb::cast<std::string>(nb::module_::import_("pliant.base.refusals").attr("shown")(value)) +
      ": must be two whole numbers from 0, the first walker and the end");
}

std::vector<OwnedRunSummary> run_ensemble_from(const nb::handle& framework, nb::object state,
                                               const nb::handle& walkers, const nb::kwargs& more) {
  const auto shard = shard_from(walkers);
  nb::dict given(more);
  Job job = usual_job("run");
  job.walkers.threads = 1;
  job.output.topology = no_topology;
  if (given.contains("threads"))
    job.walkers.threads = argument_as<std::int32_t>("threads", taken(given, "threads"), "int");
  const nb::object observers_of = taken(given, "observers_of");
  take_moves(given, job);
  check(EnsembleOptions{{}, {shard.first, shard.second}, static_cast<int>(job.walkers.threads)});
  job.walkers.first = static_cast<std::int64_t>(shard.first);
  job.walkers.walkers = static_cast<std::int64_t>(shard.second - shard.first);
  refuse_unknown(core().attr("run_ensemble"), nb::make_tuple(framework, state), given);
  const AskedRun asked = open_run(framework, std::move(state), nb::none(), job);
  check_pushes(asked.of(), job.run.replay);
  show_framework(job.run.technique, asked.of());
  AllWatched watched(observers_of, job);
  RunJob run(std::move(job), "");
  run.take(subject_of(asked, run.job()), python_log());
  const State start = asked.start();
  std::vector<RunSummary> summaries;
  {
    const RunWatch watch = watched.watch();
    const nb::gil_scoped_release no_gil;
    summaries = run.run(start, watch);
  }
  return watched.summaries(summaries);
}

nb::object continue_from(const std::filesystem::path& path, std::optional<std::int64_t> steps,
                         const nb::kwargs& more) {
  nb::dict given(more);
  Job job = usual_job("run");
  take_values(output_fields(), given, job.output);
  job.go_on = path_text(path);
  job.walkers.threads = 1;
  const nb::object observers = taken(given, "observers");
  refuse_unknown(core().attr("continue_run"), nb::make_tuple(nb::none()), given);
  const std::vector<nb::object> all =
      observers.is_none() ? std::vector<nb::object>() : members_of("observers", observers);
  AllWatched watched(nb::cpp_function([&all](std::int64_t) { return all; }), job);
  std::vector<RunSummary> summaries;
  {
    const RunWatch watch = watched.watch();
    const Log log = python_log();
    const nb::gil_scoped_release no_gil;
    summaries = ContinuedRun(std::move(job), steps, "", log).run(watch);
  }
  return result_of(watched.summaries(summaries).front(), nb::none(), path_text(path));
}

constexpr const char* doc_of_run =
    R"(Push a framework again and again, resolve the bars that break, and record each step.

Each step breaks bars by a perturbation (position Verlet: Verlet, Phys. Rev. 159 (1967) 98; or
random displacements, as in FRODA) and makes them whole by a technique, as ``resolve`` does. Step 0
is the start, resolved first if it is broken. The same arguments give the same bits. Other Python
threads run meanwhile. Ctrl-C ends the run after a sweep: the file is closed properly, then
KeyboardInterrupt is raised.

Parameters
----------
framework : Framework, Structure, path, Universe, AtomGroup, rdkit.Chem.Mol, ...
    A framework, or a molecule as ``sample`` takes it, whose framework is built with ``bars``
    and ``pin``. A file is read as the command does: a molecule with the bonds that it
    lacks perceived, or graph XML.
state : State or (N, 3) Angstrom, optional
    Where to start. A State is changed in place; positions are copied. Default: those of the
    structure.
)";

constexpr const char* doc_of_guide = R"(guide : Guide, optional
    Where joints are asked to go, in place of ``perturb``, until they have arrived;
    ``displacement`` at most in a step.
walker : int
    All random numbers are functions of the seed, this, the step and the joint.
structure : Structure, optional
    The structure whose bonds and masses are recorded with a framework that you have made.
observers : callables
    Each is called with a ``Frame``. If one returns something true, the run ends after that frame.
    If one raises an exception, the run ends with it.
parameters : dict, optional
    Further values for /parameters of the file, by path.
)";

constexpr const char* doc_of_refusals = R"(
Returns
-------
RunResult
    A RunSummary with the frames. Its ``state`` is where the run ended. Steps that did not
    converge are counted; they raise nothing.

Raises
------
OptionError
    An option is out of range; the message names it.
InputError
    Positions that cannot carry the framework: not finite, or too far from the origin.
FileError
    The file exists (and ``overwrite`` is false) or cannot be written.
)";

constexpr const char* doc_of_ensemble =
    R"(Run many walkers from one start, on threads and in lanes.

Each walker does what ``run`` does with its number, whatever the shard and the threads: two halves
of the walkers on two machines give the same bits as all of them in one call.

Parameters
----------
framework : Framework
state : State or (N, 3) Angstrom
    Where all walkers start; it is not changed.
shard : (first, end)
    The walkers to run: first, first + 1, ..., end - 1.
threads : int
    Number of threads; up to eight walkers step together on each if lanes can take them (bars
    alone), else one follows the other.
observers_of : callable, optional
    Called with a walker's number before it begins; returns its observers. Each frame that they see
    holds a copy of its positions. Recorders are closed when their walker ends. An exception of an
    observer stops its own walker only.
)";

constexpr const char* doc_of_summaries = R"(
Returns
-------
list of RunSummary
    In the order of the walkers' numbers. ``state`` is where a walker ended; None if it never
    began.

Raises
------
OptionError, InputError
    As for ``run``. The first exception of an observer is raised once all walkers have ended.
)";

constexpr const char* continue_doc =
    R"(Go on with the run of an H5MD file, as if it had never stopped.

The file holds the framework, every option and where the run was, after its end, Ctrl-C or a crash.
Frames are added to it. Together they have the bits of one run without an end between. A last frame
that is none of every N-th was only the end of the run, and makes way.

Parameters
----------
path : str or path
    A file that ``run`` or the command has written.
steps : int, optional
    How many steps the run is to have in all, those in the file included. Default: as many as it was
    asked for.
observers : callables
    As for ``run``. They see each frame from the last checkpoint on, about a second before the end
    of a run that was killed.
flush_seconds : float
    As for ``H5mdRecorder``.

Returns
-------
RunResult
    A RunSummary of the steps that were done now; its frames are all of the file.

Raises
------
InputError
    The file has no checkpoint, or the technique is a function.
OptionError
    The file has more steps than ``steps``.
FileError
    The file cannot be written, or is being written.
)";

constexpr const char* observers_type =
    "collections.abc.Iterable[collections.abc.Callable[[Frame], object]] = ()";

std::string signature() {
  Job usual = usual_job("run");
  std::string text = "def run(framework: Framework | " + std::string(any_molecule) +
                     ", state: State | numpy.typing.ArrayLike | None = None";
  for (const auto& field : output_fields()) {
    if (field.users.python) text += ", " + argument_text(field, field.place(usual.output));
    if (field.name == "output") text += ", *, " + argument_texts_of_moves();
  }
  return text + ", " + argument_texts(bars_fields(), BarsAsked()) + ", " +
         argument_text(select_row(), &usual.molecule.input.select) + ", " +
         argument_text(forces_row(), &usual.walkers.record_forces) +
         ", guide: Guide | None = None, walker: int = 0, structure: Structure | None = None, "
         "observers: " +
         observers_type +
         ", parameters: collections.abc.Mapping[str, bool | int | float | str] | None = None) "
         "-> RunResult";
}

std::string run_doc() {
  Job usual = usual_job("run");
  std::string text = doc_of_run;
  for (const auto& field : output_fields()) {
    if (field.users.python) text += argument_doc(field, field.place(usual.output));
    if (field.name == "output") text += argument_docs_of_moves();
  }
  return text + argument_docs(bars_fields(), BarsAsked()) +
         argument_doc(select_row(), &usual.molecule.input.select) +
         argument_doc(forces_row(), &usual.walkers.record_forces) + doc_of_guide + doc_of_refusals;
}

}  // namespace

void bind_run(nb::module_& module) {
  bind_run_summary(module);
  const std::string of_moves = argument_texts_of_moves();
  module.def("run", &run_from, "framework"_a.none(), "state"_a = nb::none(),
             "output"_a = nb::none(), "options"_a, nb::sig(signature().c_str()), run_doc().c_str());
  module.def(
      "run_ensemble", &run_ensemble_from, "framework"_a, "state"_a,
      "shard"_a = nb::make_tuple(0, 8), "options"_a,
      nb::sig(("def run_ensemble(framework: Framework, state: State | numpy.typing.ArrayLike, "
               "shard: tuple[int, int] = (0, 8), *, threads: int = 1, observers_of: "
               "collections.abc.Callable[[int], collections.abc.Iterable["
               "collections.abc.Callable[[Frame], object] | H5mdRecorder]] | None = None, " +
               of_moves + ") -> list[RunSummary]")
                  .c_str()),
      (doc_of_ensemble + argument_docs_of_moves() + doc_of_summaries).c_str());
  module.def("continue_run", &continue_from, "path"_a, "steps"_a = nb::none(), "options"_a,
             nb::sig((std::string("def continue_run(path: str | os.PathLike[str], steps: int | "
                                  "None = None, *, observers: ") +
                      observers_type + ", flush_seconds: float = 1.0) -> RunResult")
                         .c_str()),
             continue_doc);
}

}  // namespace pliant::python
