// SPDX-License-Identifier: MIT
// Sampling: ways to move, and ensembles of frames.
#include <nanobind/stl/pair.h>

#include <optional>
#include <utility>

#include "interrupt.hpp"
#include "messages.hpp"
#include "model/model_arguments.hpp"
#include "molecule/structure.hpp"
#include "option_fields.hpp"
#include "pliant/base/error.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/jobs/sample_job.hpp"
#include "pliant/molecule/drawing.hpp"
#include "pliant/sample/samplers.hpp"
#include "sample/sampled_ensemble.hpp"
#include "tables.hpp"

namespace pliant::python {
namespace {

/// The model that is given, or that of a structure; its kind is then in the job.
MolecularModel model_from(const nb::handle& argument, Job& job, AskedModel asked) {
  ModelAsked& model = job.molecule.model;
  if (nb::isinstance<MolecularModel>(argument)) {
    refuse_for_built_model(asked);
    if (model.model != automatic_model)
      throw OptionError("model: goes with a structure, not with a model");
    const auto& given = nb::cast<const MolecularModel&>(argument);
    refuse_drawing(given.structure);
    model.model = entry(given.kind).name;
    return given;
  }
  const nb::object part = part_from(argument, asked);
  const auto& structure = nb::cast<const Structure&>(part);
  job.molecule.input.file = structure.source;
  job.molecule.input.frame = static_cast<std::int64_t>(structure.model);
  return sampled_model(job, structure, std::move(asked.contacts), "", python_log());
}

/// Needs the GIL not to be held.
void fill(SampledEnsemble& out, SampleJob& job, InterruptWatch& watch) {
  out.header = job.header();
  out.summary = job.run([&](const Frame& frame) {
    out.add(frame);
    return watch(frame.step - job.job().sample.first_frame + 1);
  });
}

/// As a class of pliant that has methods of frames besides, and is written in Python.
template <class Made>
nb::object in_python(const char* name, Made made, const std::string& path) {
  nb::object object = nb::inst_alloc(nb::module_::import_("pliant.trajectory.results").attr(name));
  new (nb::inst_ptr<Made>(object)) Made(std::move(made));
  nb::inst_mark_ready(object);
  if (!path.empty()) object.attr("output") = path_of(path);
  return object;
}

/// The rows of a sample that scripts set, but for its molecule and its output.
Job take_job(nb::dict given) {
  Job job = usual_job("sample");
  take_values(sample_fields(), given, job.sample);
  const ModelField& model = model_fields().front();
  if (given.contains("model")) {
    take_value(model, model.place(job.molecule.model), given["model"]);
    nb::del(given["model"]);
  }
  job.output = take_output(given);
  return job;
}

nb::object sample_from(const nb::handle& structure, const nb::object& frames,
                       const nb::kwargs& more) {
  nb::dict given(more);
  if (!frames.is_none()) given["frames"] = frames;
  Job job = take_job(given);
  AskedModel asked = take_arguments(ModelArguments::all, given);
  const std::string kind = job.molecule.model.model;
  job.molecule.model = asked.model;
  job.molecule.model.model = kind;
  job.molecule.input = asked.input;
  refuse_unknown(nb::module_::import_("pliant._core").attr("sample"), nb::make_tuple(structure),
                 given);
  check_open(job.sample);
  MolecularModel model = model_from(structure, job, std::move(asked));
  SampledEnsemble out{std::move(model), {}, {}, {}, {}, {}, {}};
  SampleJob sample(std::move(job), out.model, "", python_log());
  out.amplitude = sample.system().amplitude;
  InterruptWatch watch("frames", sample.job().sample.frames);
  {
    const nb::gil_scoped_release no_gil;
    fill(out, sample, watch);
  }
  if (watch.raised()) std::rethrow_exception(watch.raised());
  warn_of_amplitude(out.summary, python_log());
  if (sample.task().conformers()) out.model.framework = *sample.task().conformers();
  const std::string& path = sample.job().output.output;
  return in_python("SampledEnsemble", std::move(out), path);
}

nb::object continue_from(const std::filesystem::path& path, std::optional<std::int64_t> frames,
                         const nb::kwargs& more) {
  nb::dict given(more);
  Job job = take_job(given);
  refuse_unknown(nb::module_::import_("pliant._core").attr("continue_sample"),
                 nb::make_tuple(nb::none()), given);
  job.go_on = path_text(path);
  InterruptWatch watch;
  SampleSummary summary;
  const Log log = python_log();
  {
    const nb::gil_scoped_release no_gil;
    ContinuedSample sample(std::move(job), frames, "", log);
    summary = sample.run([&](const Frame&) { return watch(); });
  }
  if (watch.raised()) std::rethrow_exception(watch.raised());
  return in_python("SampleResult", std::move(summary), path_text(path));
}

constexpr const char* doc_of_sample =
    R"(Samples what a molecule can do: independent frames about its structure, bars exact.

How far frames go is an input, not a prediction, and how often each occurs is not claimed.

Parameters
----------
structure : Structure, path, Universe, AtomGroup, rdkit.Chem.Mol or MolecularModel
    A molecule; of a Universe the current frame, of an RDKit molecule the first conformer. OpenMM's,
    ProDy's and MDTraj's molecules are taken, too. Or the model of a structure.
)";

constexpr const char* doc_of_refusals =
    R"(
Returns
-------
SampledEnsemble

Raises
------
OptionError
    An option out of range or of no known name, a model with pinned atoms, useless B factors.
InputError
    As ``build_model``, where the start of a model is not whole, or a file of models has others.
FileError
    The file exists (and ``overwrite`` is false) or cannot be written. ``continue_sample`` goes on
    with the file.
)";

constexpr const char* continue_doc =
    R"(Continues a sample in an H5MD file, as if it had never stopped.

The file holds the framework, where frames start and every option, after the end of ``sample`` or
``pliant sample``, Ctrl-C or a crash. Frames are added to it. Together they have the bits of one
sample without an end between. The last frame that is there is made once more, to see that it comes
out the same.

Parameters
----------
path : str or path
    A file that ``sample`` or the command has written.
frames : int, optional
    How many frames there are to be in all, those in the file included. Default: as many as it was
    asked for.
threads : int
    From 1; changes no result. Default: all cores.
flush_seconds : float
    As for ``H5mdRecorder``.

Returns
-------
SampleResult
    A SampleSummary of the frames that were added, whose figures on atoms look at the last frame from
    before, too. It has all frames of the file.

Raises
------
InputError
    The file does not say how its sample goes on, or holds a run.
OptionError
    The file has more frames than ``frames``.
FileError
    The file cannot be written, is being written, or was written by a version of Pliant whose
    frames have other bits.
)";

/// Options of scripts: frames come first and may be given by place.
std::string signature() {
  SampleOptions usual = unset_sample_options();
  ModelAsked model{.model = std::string(automatic_model)};
  std::string text = "def sample(structure: MolecularModel | " + std::string(any_molecule);
  for (const SampleField& field : sample_fields()) {
    if (field.users.python) text += ", " + argument_text(field, field.place(usual));
    if (field.name == "frames") text += ", *";
  }
  const ModelField& kind = model_fields().front();
  return text + ", " + argument_text(kind, kind.place(model)) + ", " +
         argument_texts(ModelArguments::all) + ", " +
         argument_texts(output_fields(), OutputOptions()) + ") -> SampledEnsemble";
}

std::string sample_doc() {
  ModelAsked model{.model = std::string(automatic_model)};
  const ModelField& kind = model_fields().front();
  return doc_of_sample + argument_docs(sample_fields(), unset_sample_options()) +
         argument_doc(kind, kind.place(model)) + argument_docs(ModelArguments::all) +
         argument_docs(output_fields(), OutputOptions()) + doc_of_refusals;
}

/// Rows of a task for commands that are written in Python.
nb::list job_rows_of(const std::string& task) {
  nb::list rows;
  Job usual = usual_job(task);
  for (const OptionRow<Job>& row : job_rows(task))
    if (row.facts->users.command) rows.append(row_of(*row.facts, row.place(usual)));
  return rows;
}

void bind_sample_function(nb::module_& module) {
  module.def("job_rows", &job_rows_of, "task"_a,
             nb::sig("def job_rows(task: str) -> list[dict[str, typing.Any]]"),
             "The table of the options of a job: ``sample``, ``run`` or ``conformers``.");
  module.def(
      "near_frames",
      [](std::int64_t frames) {
        SampleOptions options;
        options.frames = frames;
        return near_frames_of(options);
      },
      "frames"_a, "How many of so many frames of sampler ``reach`` are those of ``modes``.");
  module.def("sample", &sample_from, "structure"_a.none(), "frames"_a = nb::none(), "options"_a,
             nb::sig(signature().c_str()), sample_doc().c_str());
}

}  // namespace

void bind_sample(nb::module_& module) {
  bind_row<SamplerEntry>(module, "SamplerEntry", "One row of the table of samplers.")
      .def_ro("has_amplitude", &SamplerEntry::has_amplitude,
              "Whether frames are asked for an amplitude (Angstrom).")
      .def_ro("has_place", &SamplerEntry::has_place, "Whether it takes ``around``.")
      .def_ro("near_sampler", &SamplerEntry::near_sampler,
              "The sampler that draws its first ``near_frames``; empty: none does.")
      .def_ro("frames", &SamplerEntry::frames, "How many, if not said.");
  module.def(
      "drawn_by_table",
      [] {
        std::vector<std::pair<std::string_view, bool>> rows;
        for (const DrawnByEntry& row : drawn_by_table()) rows.emplace_back(row.name, row.is_near);
        return rows;
      },
      "How frames of samplers may be drawn, by the number in ``/observables/sampler``: name, and\n"
      "whether they are around the start.");
  module.def(
      "samplers", [] { return rows_of(samplers()); }, nb::rv_policy::reference,
      "The table of ways to move that ``sample`` knows.");
  bind_sampled_ensemble(module);
  bind_sample_function(module);
  module.def("continue_sample", &continue_from, "path"_a, "frames"_a = nb::none(), "options"_a,
             nb::sig("def continue_sample(path: str | os.PathLike[str], frames: int | None = None, "
                     "*, threads: int | None = None, flush_seconds: float = 1.0) -> "
                     "SampleResult"),
             continue_doc);
}

}  // namespace pliant::python
