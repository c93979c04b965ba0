// SPDX-License-Identifier: MIT
// Sampling: ways to move, and ensembles of frames.
#include <optional>
#include <utility>

#include "arrays.hpp"
#include "interrupt.hpp"
#include "messages.hpp"
#include "molecule/structure.hpp"
#include "option_fields.hpp"
#include "pliant/base/choices.hpp"
#include "pliant/base/error.hpp"
#include "pliant/model/model.hpp"
#include "pliant/molecule/drawing.hpp"
#include "pliant/molecule/selection.hpp"
#include "pliant/resume/recorded_sample.hpp"
#include "pliant/sample/sample_fields.hpp"
#include "pliant/sample/samplers.hpp"
#include "pliant/tasks/asked_amplitude.hpp"
#include "pliant/tasks/sample_task.hpp"
#include "record/recorded_bonds.hpp"
#include "sample/asked_amplitude.hpp"
#include "tables.hpp"

namespace pliant::python {
namespace {

/// Frames, and what they were made of.
struct SampledEnsemble {
  MolecularModel model;
  AmplitudeChoice amplitude;
  std::vector<Vec3> positions;  ///< (F * N)
  SampleSummary summary;
};

MolecularModel model_from(const nb::handle& argument, const std::string& model,
                          std::vector<std::string> keep) {
  if (nb::isinstance<MolecularModel>(argument)) {
    if (!keep.empty()) throw OptionError("keep: goes with a structure, not with a model");
    if (!model.empty()) throw OptionError("model: goes with a structure, not with a model");
    refuse_drawing(nb::cast<const MolecularModel&>(argument).structure);
    return nb::cast<MolecularModel>(argument);
  }
  if (!nb::isinstance<Structure>(argument))
    throw nb::type_error("structure: expected a Structure or a MolecularModel");
  const auto& structure = nb::cast<const Structure&>(argument);
  refuse_drawing(structure);
  ModelOptions options;
  options.kind = usual_model(structure);
  if (!model.empty()) options.kind = choose(models(), "model", model).kind;
  options.prepare.keep = std::move(keep);
  options.log = python_log();
  return build_model(structure, options);
}

/// Where frames are written besides.
struct Output {
  std::optional<std::filesystem::path> path;
  H5mdOptions options;
  std::string save = {};  ///< selection of the atoms; "": all
};

Output output_from(const std::optional<std::filesystem::path>& path, bool overwrite, bool single,
                   bool compress, double precision, const std::string& save) {
  if (path && path->extension() != ".h5md" && path->extension() != ".h5")
    throw OptionError("output: " + path->string() +
                      ": expected a name that ends in .h5md; pliant.convert writes other formats");
  return {path,
          {.single = single,
           .compress = compress,
           .precision = precision,
           .overwrite = overwrite,
           .log = unraisable_python_log()},
          save};
}

H5mdHeader header_of_sample(const SampledEnsemble& made, const SampleTask& task,
                            const Output& output) {
  H5mdHeader header = header_of(&made.model.structure);
  header.inputs = sample_inputs(task.start(), task.nodes());
  header.parameters = parameters_of(task.options());
  const std::string file = std::filesystem::path(made.model.structure.source).filename().string();
  header.parameters.insert(header.parameters.end(),
                           {{"input/file", file},
                            {"sample/amplitude_from", made.amplitude.source},
                            {"sample/amplitude_reason", made.amplitude.reason},
                            {"model/kind", std::string(entry(made.model.kind).name)},
                            left_out_of(made.model)});
  for (NamedParameter& one : parameters_of(output.options, output.save))
    header.parameters.push_back(std::move(one));
  return header;
}

/// Needs the GIL not to be held.
void fill(SampledEnsemble& out, const SampleTask& task, const Output& output,
          InterruptWatch& watch) {
  std::optional<H5mdRecorder> recorder;
  if (output.path)
    recorder.emplace(*output.path, task.framework(), header_of_sample(out, task, output),
                     output.options);
  out.summary = task.run([&](const Frame& frame) {
    if (recorder) recorder->record(frame);
    out.positions.insert(out.positions.end(), frame.positions.begin(), frame.positions.end());
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

SampledEnsemble sample_from(const nb::handle& structure, const nb::object& frames,
                            const std::optional<AskedAmplitude>& amplitude,
                            const std::string& model, std::vector<std::string> keep,
                            const std::optional<std::filesystem::path>& path, bool overwrite,
                            bool single, bool compress, double precision, const std::string& save,
                            const nb::kwargs& more) {
  nb::dict given(more);
  if (!frames.is_none()) given["frames"] = frames;
  SampleOptions options = unset_sample_options();
  take_values(sample_fields(), given, options);
  refuse_unknown(nb::module_::import_("pliant._core").attr("sample"), nb::make_tuple(structure),
                 given);
  Output output = output_from(path, overwrite, single, compress, precision, save);
  SampledEnsemble out{model_from(structure, model, std::move(keep)), {}, {}, {}};
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
  return out;
}

SampleSummary continue_from(const std::filesystem::path& path, std::optional<std::int64_t> frames,
                            std::int64_t threads, double flush_seconds, bool durable) {
  const Log log = python_log();
  H5mdOptions recording{.flush_seconds = flush_seconds, .durable = durable};
  recording.log = unraisable_python_log();
  InterruptWatch watch;
  SampleSummary summary;
  {
    const nb::gil_scoped_release no_gil;
    const H5mdCheckpoint from = read_checkpoint(path, frames, log);
    if (!from.is_sample())
      throw InputError(path.string() + ": holds steps of a run: continue_run goes on with them");
    if (from.done > from.steps)
      throw OptionError("frames = " + std::to_string(from.steps) + ": " + path.string() + " has " +
                        std::to_string(from.done) + " frames already");
    SampleOptions options = sample_options_from(from);
    options.threads = threads;
    check(options);
    if (from.done < from.steps)
      summary = add_frames(from, options, recording, [&](const Frame&) { return watch(); });
  }
  if (watch.raised()) std::rethrow_exception(watch.raised());
  return summary;
}

using Frames = nb::ndarray<nb::numpy, double, nb::shape<-1, -1, 3>, nb::c_contig>;

Frames frames_of(nb::handle_t<SampledEnsemble> self) {
  auto& ensemble = nb::cast<SampledEnsemble&>(self);
  const std::size_t atoms = ensemble.model.positions.size();
  const std::size_t frames = atoms == 0 ? 0 : ensemble.positions.size() / atoms;
  return Frames(ensemble.positions.data(), {frames, atoms, 3}, self);
}

constexpr const char* doc_of_sample =
    R"(Samples what a molecule can do: independent frames about its structure, bars exact.

How far frames go is an input, not a prediction, and how often each occurs is not claimed.

Parameters
----------
structure : Structure or MolecularModel
    A structure with its bonds, as ``read`` gives it, or the model of one.
)";

constexpr const char* doc_of_amplitude =
    R"(amplitude : float, str or path, optional
    Mean r.m.s. fluctuation of residues (Angstrom), ``"bfactors"``, or a file of models or frames; 1.4
    if none is given. Samplers ``torsions`` take none.
)";

constexpr const char* doc_of_the_rest =
    R"(model : str
    A name in ``models()``; empty: ``protein`` where there are residues, else ``molecule``.
keep : sequence of str
    Molecules of crystallisation that stay; as for ``build_model``.
output : str or path, optional
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
    From 1; changes no result.
flush_seconds, durable
    As for ``H5mdRecorder``.

Returns
-------
SampleSummary
    Of the frames that were added. Figures on atoms look at the last frame from before, too.

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

const SampleSummary& summary_of(const SampledEnsemble& self) { return self.summary; }
const SampleSummary& summary_of(const SampleSummary& self) { return self; }

/// What an ensemble and its summary both tell.
template <class T>
void bind_summary(nb::class_<T>& to) {
  to.def_prop_ro(
        "redrawn", [](const T& self) { return summary_of(self).redrawn; },
        "Frames whose first draw could not be resolved.")
      .def_prop_ro(
          "failed", [](const T& self) { return summary_of(self).failed; },
          "Frames that no draw gave; they are left out.")
      .def_prop_ro(
          "amplitude_reached", [](const T& self) { return summary_of(self).amplitude_reached; },
          "Mean r.m.s. fluctuation of residues in frames, superposed (Angstrom).")
      .def_prop_ro(
          "max_residual", [](const T& self) { return summary_of(self).max_residual; },
          "Worst bar of all frames: abs(length - rest) / rest.")
      .def_prop_ro(
          "max_limit", [](const T& self) { return summary_of(self).max_limit; },
          "Largest distance of a contact outside its interval (Angstrom).")
      .def_prop_ro(
          "max_overlap", [](const T& self) { return summary_of(self).max_overlap; },
          "Largest overlap of two atoms (Angstrom).")
      .def_prop_ro(
          "rmsf", [](const T& self) { return array_of(summary_of(self).rmsf); },
          nb::rv_policy::reference,
          "(N,) float64: r.m.s. fluctuation of each atom about its mean, frames superposed "
          "(Angstrom).")
      .def_prop_ro(
          "rmsf_error", [](const T& self) { return array_of(summary_of(self).rmsf_error); },
          nb::rv_policy::reference,
          "(N,) float64: half the difference between halves of the frames (Angstrom).");
}

void bind_ensemble_class(nb::module_& module) {
  nb::class_<SampleSummary> summary(module, "SampleSummary", "What sampling did.");
  summary.def_ro("frames", &SampleSummary::frames, "Frames made.");
  bind_summary(summary);
  nb::class_<SampledEnsemble> ensemble(module, "SampledEnsemble",
                                       "Frames of a molecule, and how exact they are.");
  ensemble.def_ro("model", &SampledEnsemble::model, "What was sampled.")
      .def_prop_ro(
          "amplitude_asked", [](const SampledEnsemble& self) { return self.amplitude.value; },
          "Mean r.m.s. fluctuation of residues that was asked for (Angstrom).")
      .def_prop_ro(
          "amplitude_reason", [](const SampledEnsemble& self) { return self.amplitude.reason; },
          "Origin of the amplitude that was asked for, in words.")
      .def_prop_ro("positions", &frames_of, "(F, N, 3) float64 view, Angstrom.");
  bind_summary(ensemble);
}

/// Options of scripts: frames come first and may be given by place.
std::string signature() {
  SampleOptions usual = unset_sample_options();
  std::string text = "def sample(structure: Structure | MolecularModel";
  for (const SampleField& field : sample_fields()) {
    if (field.name == "frames")
      text += ", frames: int | None = None, *, amplitude: float | str | os.PathLike | None = None";
    else if (field.users.python)
      text += ", " + argument_text(field, field.place(usual));
  }
  return text +
         ", model: str = \"\", keep: collections.abc.Sequence[str] = (), "
         "output: str | os.PathLike[str] | None = None, "
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
  return text + doc_of_the_rest;
}

void bind_sample_function(nb::module_& module) {
  module.def("sample", &sample_from, "structure"_a, "frames"_a = nb::none(), nb::kw_only(),
             "amplitude"_a = nb::none(), "model"_a = "", "keep"_a = std::vector<std::string>{},
             "output"_a = nb::none(), "overwrite"_a = false, "single"_a = false,
             "compress"_a = false, "precision"_a = 0.0, "save"_a = "", "options"_a,
             nb::sig(signature().c_str()), sample_doc().c_str());
}

}  // namespace

void bind_sample(nb::module_& module) {
  bind_row<SamplerEntry>(module, "SamplerEntry", "One row of the table of samplers.")
      .def_ro("has_amplitude", &SamplerEntry::has_amplitude,
              "Whether frames are asked for an amplitude (Angstrom).");
  module.def(
      "samplers", [] { return rows_of(samplers()); }, nb::rv_policy::reference,
      "The table of ways to move that ``sample`` knows.");
  bind_ensemble_class(module);
  bind_sample_function(module);
  const SampleOptions usual;
  module.def("continue_sample", &continue_from, "path"_a, "frames"_a = nb::none(), nb::kw_only(),
             "threads"_a = usual.threads, "flush_seconds"_a = 1.0, "durable"_a = false,
             continue_doc);
}

}  // namespace pliant::python
