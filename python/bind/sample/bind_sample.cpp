// SPDX-License-Identifier: MIT
// Sampling: ways to move, and ensembles of frames.
#include <algorithm>
#include <optional>
#include <thread>
#include <utility>

#include "interrupt.hpp"
#include "messages.hpp"
#include "model/model_arguments.hpp"
#include "molecule/structure.hpp"
#include "option_fields.hpp"
#include "pliant/base/choices.hpp"
#include "pliant/base/error.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/jobs/asked_amplitude.hpp"
#include "pliant/jobs/recorded_sample.hpp"
#include "pliant/jobs/sample_task.hpp"
#include "pliant/model/model.hpp"
#include "pliant/model/prepare/largest_molecule.hpp"
#include "pliant/molecule/drawing.hpp"
#include "pliant/molecule/selection.hpp"
#include "pliant/sample/sample_fields.hpp"
#include "pliant/sample/samplers.hpp"
#include "sample/asked_amplitude.hpp"
#include "sample/sampled_ensemble.hpp"
#include "tables.hpp"

namespace pliant::python {
namespace {

MolecularModel model_from(const nb::handle& argument, const std::string& model, AskedModel asked) {
  if (nb::isinstance<MolecularModel>(argument)) {
    refuse_for_built_model(asked);
    if (!model.empty()) throw OptionError("model: goes with a structure, not with a model");
    refuse_drawing(nb::cast<const MolecularModel&>(argument).structure);
    return nb::cast<MolecularModel>(argument);
  }
  const nb::object part = part_from(argument, asked);
  const auto& structure = nb::cast<const Structure&>(part);
  refuse_drawing(structure);
  ModelOptions& options = asked.options;
  options.kind = usual_model(structure);
  if (!model.empty()) options.kind = choose(models(), "model", model).kind;
  refuse_unused(asked, options.kind);
  if (options.kind != ModelKind::molecule) return build_model(structure, options);
  return build_model(largest_molecule(structure, options.log), options);
}

/// Needs the GIL not to be held.
void fill(SampledEnsemble& out, const SampleTask& task, const SampleOutput& output,
          InterruptWatch& watch) {
  out.header = header_of_sample(out.model, out.amplitude, task);
  std::optional<H5mdRecorder> recorder;
  if (output.path)
    recorder.emplace(*output.path, task.framework(), header_for(out.header, output),
                     output.options);
  out.summary = task.run([&](const Frame& frame) {
    if (recorder) recorder->record(frame);
    out.add(frame);
    return watch(frame.step - task.options().first_frame + 1);
  });
  if (recorder) recorder->close();
}

/// How far frames go is then in `out`.
SampleAsked asked_of(SampledEnsemble& out, const std::optional<AskedAmplitude>& amplitude,
                     SampleOptions options) {
  options.log = python_log();
  const std::string text = amplitude_text(amplitude.value_or(usual_amplitude));
  out.amplitude = asked_amplitude(text, out.model.structure, python_log());
  SampleAsked asked{std::move(options)};
  if (amplitude) asked.amplitude = out.amplitude;
  return asked;
}

std::int64_t all_cores() { return std::max(1U, std::thread::hardware_concurrency()); }

/// As a class of pliant that has methods of frames besides, and is written in Python.
template <class Made>
nb::object in_python(const char* name, Made made,
                     const std::optional<std::filesystem::path>& path) {
  nb::object object = nb::inst_alloc(nb::module_::import_("pliant._trajectory.results").attr(name));
  new (nb::inst_ptr<Made>(object)) Made(std::move(made));
  nb::inst_mark_ready(object);
  if (path) object.attr("output") = *path;
  return object;
}

/// What is wrong with options whatever the molecule is; no file is read before.
void check_before(SampleOptions options) {
  if (options.sampler == automatic_sampler) options.sampler = SampleOptions{}.sampler;
  if (options.frames == open_frames) options.frames = SampleOptions{}.frames;
  check(options);
}

nb::object sample_from(const nb::handle& structure, const nb::object& frames,
                       const std::optional<AskedAmplitude>& amplitude, const std::string& model,
                       const std::optional<std::filesystem::path>& path, bool overwrite,
                       bool single, bool compress, double precision, const std::string& save,
                       const nb::kwargs& more) {
  nb::dict given(more);
  if (!frames.is_none()) given["frames"] = frames;
  SampleOptions options = unset_sample_options();
  options.threads = all_cores();
  take_values(sample_fields(), given, options);
  AskedModel asked_model = take_arguments(model_arguments(), given);
  refuse_unknown(nb::module_::import_("pliant._core").attr("sample"), nb::make_tuple(structure),
                 given);
  check_before(options);
  SampleOutput output = sample_output(path, overwrite, single, compress, precision, save);
  SampledEnsemble out{model_from(structure, model, std::move(asked_model)), {}, {}, {}, {}, {}, {}};
  const SampleAsked asked = asked_of(out, amplitude, std::move(options));
  const SampleTask task(subject_of(out.model), asked);
  InterruptWatch watch("frames", task.options().frames);
  output.options.saved = select_joints(task.framework(), save, "save");
  {
    const nb::gil_scoped_release no_gil;
    fill(out, task, output, watch);
  }
  if (watch.raised()) std::rethrow_exception(watch.raised());
  warn_of_amplitude(out.summary, python_log());
  if (task.conformers()) out.model.framework = *task.conformers();
  return in_python("SampledEnsemble", std::move(out), path);
}

nb::object continue_from(const std::filesystem::path& path, std::optional<std::int64_t> frames,
                         std::optional<std::int64_t> threads, double flush_seconds, bool durable) {
  const Log log = python_log();
  H5mdOptions recording{.flush_seconds = flush_seconds, .durable = durable};
  recording.log = unraisable_python_log();
  InterruptWatch watch;
  SampleSummary summary;
  {
    const nb::gil_scoped_release no_gil;
    const H5mdCheckpoint from = read_checkpoint(path, frames, log);
    if (!from.is_sample())
      throw InputError(path_text(path) + ": holds steps of a run: continue_run goes on with them");
    if (from.done > from.steps)
      throw OptionError("frames = " + std::to_string(from.steps) + ": " + path_text(path) +
                        " has " + std::to_string(from.done) + " frames already");
    SampleOptions options = sample_options_from(from);
    options.threads = threads.value_or(all_cores());
    check(options);
    if (from.done < from.steps)
      summary = add_frames(from, options, recording, [&](const Frame&) { return watch(); });
  }
  if (watch.raised()) std::rethrow_exception(watch.raised());
  return in_python("SampleResult", std::move(summary), path);
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

constexpr const char* doc_of_amplitude =
    R"(amplitude : float, str or path, optional
    Mean r.m.s. fluctuation of residues (Angstrom), ``"bfactors"``, or a file of models or frames; 1.4
    if none is given. Samplers ``torsions`` take none.
)";

constexpr const char* doc_of_model =
    R"(model : str
    A name in ``models()``; empty: ``protein`` where there are residues, else ``molecule``.
)";

constexpr const char* doc_of_output =
    R"(output : str or path, optional
    H5MD file to write as well; ``continue_sample`` goes on with it.
overwrite, single, compress : bool
    As for ``H5mdRecorder``.
precision : float
    Angstrom; as for ``H5mdRecorder``.
save : str
    Selection of the atoms to record; as for ``H5mdRecorder``.

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
    The file exists (and ``overwrite`` is false) or cannot be written.
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
flush_seconds, durable
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
  std::vector<std::string_view> models_or_none = names_of(models());
  models_or_none.insert(models_or_none.begin(), "");
  std::string text = "def sample(structure: MolecularModel | " + std::string(any_molecule);
  for (const SampleField& field : sample_fields()) {
    if (field.name == "frames")
      text += ", frames: int | None = None, *, amplitude: float | str | os.PathLike | None = None";
    else if (field.users.python)
      text += ", " + argument_text(field, field.place(usual));
  }
  return text + ", model: " + literal_type(models_or_none) + " = \"\", " +
         argument_texts(model_arguments()) +
         ", output: str | os.PathLike[str] | None = None, "
         "overwrite: bool = False, single: bool = False, compress: bool = False, "
         "precision: float = 0.0, save: str = '') -> SampledEnsemble";
}

std::string sample_doc() {
  SampleOptions usual = unset_sample_options();
  std::string text = doc_of_sample;
  for (const SampleField& field : sample_fields()) {
    if (field.users.python) text += argument_doc(field, field.place(usual));
    if (field.name == "frames") text += doc_of_amplitude;
  }
  return text + doc_of_model + argument_docs(model_arguments()) + doc_of_output;
}

void bind_sample_function(nb::module_& module) {
  module.def(
      "near_frames",
      [](std::int64_t frames) {
        SampleOptions options;
        options.frames = frames;
        return near_frames_of(options);
      },
      "frames"_a, "How many of so many frames of sampler ``reach`` are those of ``modes``.");
  module.def("sample", &sample_from, "structure"_a.none(), "frames"_a = nb::none(), nb::kw_only(),
             "amplitude"_a = nb::none(), "model"_a = "", "output"_a = nb::none(),
             "overwrite"_a = false, "single"_a = false, "compress"_a = false, "precision"_a = 0.0,
             "save"_a = "", "options"_a, nb::sig(signature().c_str()), sample_doc().c_str());
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
      "drawn_by_names",
      [] {
        std::vector<std::string_view> names;
        for (std::size_t k = 0; k < drawn_by_count; ++k) names.push_back(name(DrawnBy(k)));
        return names;
      },
      "How frames of samplers may be drawn, by the number in ``/observables/sampler``.");
  module.def(
      "samplers", [] { return rows_of(samplers()); }, nb::rv_policy::reference,
      "The table of ways to move that ``sample`` knows.");
  bind_sampled_ensemble(module);
  bind_sample_function(module);
  module.def("continue_sample", &continue_from, "path"_a, "frames"_a = nb::none(), nb::kw_only(),
             "threads"_a = nb::none(), "flush_seconds"_a = 1.0, "durable"_a = false,
             nb::sig("def continue_sample(path: str | os.PathLike[str], frames: int | None = None, "
                     "*, threads: int | None = None, flush_seconds: float = 1.0, "
                     "durable: bool = False) -> SampleResult"),
             continue_doc);
}

}  // namespace pliant::python
