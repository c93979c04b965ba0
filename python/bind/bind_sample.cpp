// SPDX-License-Identifier: MIT
// Sampling: ways to move, and ensembles of frames.
#include <optional>

#include "arrays.hpp"
#include "asked_amplitude.hpp"
#include "interrupt.hpp"
#include "messages.hpp"
#include "network_nodes.hpp"
#include "pliant/base/choices.hpp"
#include "pliant/base/error.hpp"
#include "pliant/base/number.hpp"
#include "pliant/model/amplitude.hpp"
#include "pliant/model/model.hpp"
#include "pliant/molecule/drawing.hpp"
#include "pliant/molecule/selection.hpp"
#include "pliant/resume/recorded_sample.hpp"
#include "pliant/sample/conformer_framework.hpp"
#include "pliant/sample/sample.hpp"
#include "pliant/sample/samplers.hpp"
#include "recorded_bonds.hpp"
#include "structure.hpp"
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

MolecularModel model_from(const nb::handle& argument, const std::string& model) {
  if (nb::isinstance<MolecularModel>(argument)) {
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

H5mdHeader header_of_sample(const MolecularModel& model, const AmplitudeChoice& amplitude,
                            const NetworkNodes& nodes, const SampleOptions& options,
                            const H5mdOptions& recording, const std::string& save) {
  H5mdHeader header = header_of(&model.structure);
  header.inputs = sample_inputs(model.positions, nodes);
  header.parameters = parameters_of(options);
  const std::string file = std::filesystem::path(model.structure.source).filename().string();
  header.parameters.insert(header.parameters.end(),
                           {{"input/file", file},
                            {"sample/amplitude_from", amplitude.source},
                            {"sample/amplitude_reason", amplitude.reason},
                            {"model/kind", std::string(entry(model.kind).name)},
                            {"record/single", recording.single},
                            {"record/compress", recording.compress},
                            {"record/precision", recording.precision},
                            {"record/save", save}});
  return header;
}

/// Needs the GIL not to be held.
void fill(SampledEnsemble& out, const SampleOptions& options, const Output& output,
          InterruptWatch& watch) {
  const MolecularModel& model = out.model;
  const NetworkNodes nodes = nodes_of(model.structure);
  std::optional<H5mdRecorder> recorder;
  if (output.path)
    recorder.emplace(
        *output.path, model.framework,
        header_of_sample(model, out.amplitude, nodes, options, output.options, output.save),
        output.options);
  out.summary =
      sample(model.framework, model.positions, nodes, options, [&](const SampledFrame& frame) {
        if (recorder) recorder->record(recorded_frame(frame));
        out.positions.insert(out.positions.end(), frame.positions.begin(), frame.positions.end());
        return watch(frame.frame - options.first_frame + 1);
      });
  if (recorder) recorder->close();
}

/// Version 0.3.0 took a temperature in kJ/mol.
void refuse_former(const std::optional<double>& temperature) {
  if (temperature)
    throw OptionError("temperature is now contact_energy, in kcal/mol: contact_energy=" +
                      number_text(*temperature / kj_per_kcal, 6));
}

SampledEnsemble sample_from(const nb::handle& structure, std::int64_t frames,
                            const std::optional<AskedAmplitude>& amplitude, std::uint64_t seed,
                            int threads, const std::string& network, const std::string& sampler,
                            std::int64_t first_frame, double contact_energy,
                            const std::string& model,
                            const std::optional<std::filesystem::path>& path, bool overwrite,
                            bool single, bool compress, double precision, const std::string& save,
                            const std::optional<double>& temperature) {
  refuse_former(temperature);
  Output output = output_from(path, overwrite, single, compress, precision, save);
  SampledEnsemble out{model_from(structure, model), {}, {}, {}};
  out.amplitude = amplitude_of(amplitude.value_or(usual_amplitude), out.model.structure);
  InterruptWatch watch("frames", frames);
  SampleOptions options;
  options.frames = frames;
  options.first_frame = first_frame;
  options.amplitude = out.amplitude.value;
  options.seed = seed;
  options.threads = threads;
  options.network = network;
  options.log = python_log();
  options.sampler = sampler;
  if (sampler == "auto")
    options.sampler = usual_sampler(out.model.framework, out.model.positions,
                                    usual_model(out.model.structure) == ModelKind::protein);
  options.contact_energy = contact_energy;
  check(options);
  const bool has_amplitude = find_sampler(options.sampler).has_amplitude;
  if (amplitude && !has_amplitude)
    throw OptionError("amplitude: sampler " + options.sampler +
                      " has none: how far torsions turn is drawn");
  if (!has_amplitude)
    out.model.framework = conformer_framework(out.model.framework, out.model.positions);
  output.options.saved = select_joints(out.model.framework, save, "save");
  {
    const nb::gil_scoped_release no_gil;
    fill(out, options, output, watch);
  }
  if (watch.raised()) std::rethrow_exception(watch.raised());
  warn_of_amplitude(out.summary, python_log());
  return out;
}

SampleSummary continue_from(const std::filesystem::path& path, std::optional<std::int64_t> frames,
                            int threads, double flush_seconds, bool durable) {
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
      summary = add_frames(from, options, recording, [&](const SampledFrame&) { return watch(); });
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

constexpr const char* sample_doc =
    R"(Samples what a molecule can do: independent frames about its structure, bars exact.

How far frames go is an input, not a prediction, and how often each occurs is not claimed.

Parameters
----------
structure : Structure or MolecularModel
    A structure with its bonds, as ``read`` gives it, or the model of one.
frames : int
    How many, from 1.
amplitude : float, str or path, optional
    Mean r.m.s. fluctuation of residues (Angstrom), ``"bfactors"``, or a file of models or frames; 1.4
    if none is given. Samplers ``torsions`` take none.
seed : int
    Of all random numbers. Frames are a function of the model, the seed and their number.
threads : int
    From 1; changes no result.
network : str
    A name in ``networks()``.
sampler : str
    A name in ``samplers()``, or ``auto``: ``modes`` where there are residues, ``torsions`` of small
    molecules, which have no amplitude.
first_frame : int
    Number of the first frame: a run may be made in pieces.
contact_energy : float
    Of sampler ``dilute`` (kcal/mol): a contact of energy E is off with probability
    exp(-abs(E) / contact_energy).
model : str
    A name in ``models()``; empty: ``protein`` where there are residues, else ``molecule``.
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
    R"(Goes on with the frames of an H5MD file, as if it had never stopped.

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
          "Where the amplitude that was asked for is from, in words.")
      .def_prop_ro("positions", &frames_of, "(F, N, 3) float64 view, Angstrom.");
  bind_summary(ensemble);
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
  const SampleOptions usual;
  module.def(
      "sample", &sample_from, "structure"_a, "frames"_a = usual.frames, nb::kw_only(),
      "amplitude"_a = nb::none(), "seed"_a = usual.seed, "threads"_a = usual.threads,
      "network"_a = usual.network, "sampler"_a = "auto", "first_frame"_a = usual.first_frame,
      "contact_energy"_a = usual.contact_energy, "model"_a = "", "output"_a = nb::none(),
      "overwrite"_a = false, "single"_a = false, "compress"_a = false, "precision"_a = 0.0,
      "save"_a = "", "temperature"_a = nb::none(),
      nb::sig(
          "def sample(structure: Structure | MolecularModel, frames: int = 200, *, "
          "amplitude: float | str | os.PathLike | None = None, seed: int = 0, threads: int = 1, "
          "network: str = \"shared\", sampler: str = \"auto\", first_frame: int = 0, "
          "contact_energy: float = 3.0, model: str = \"\", "
          "output: str | os.PathLike[str] | None = None, overwrite: bool = False, "
          "single: bool = False, compress: bool = False, precision: float = 0.0, "
          "save: str = '') -> SampledEnsemble"),
      sample_doc);
  module.def("continue_sample", &continue_from, "path"_a, "frames"_a = nb::none(), nb::kw_only(),
             "threads"_a = usual.threads, "flush_seconds"_a = 1.0, "durable"_a = false,
             continue_doc);
}

}  // namespace pliant::python
