// SPDX-License-Identifier: MIT
#include "sample/sampled_ensemble.hpp"

#include <nanobind/stl/filesystem.h>

#include <utility>

#include "arrays.hpp"
#include "messages.hpp"
#include "pliant/base/error.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/jobs/recorded_sample.hpp"
#include "pliant/model/model.hpp"
#include "pliant/molecule/selection.hpp"
#include "record/recorded_bonds.hpp"

namespace pliant::python {
namespace {

using Frames = nb::ndarray<nb::numpy, double, nb::shape<-1, -1, 3>, nb::c_contig>;

Frames sampled_frames(nb::handle_t<SampledEnsemble> self) {
  auto& ensemble = nb::cast<SampledEnsemble&>(self);
  const std::size_t atoms = ensemble.atoms();
  const std::size_t frames = atoms == 0 ? 0 : ensemble.positions.size() / atoms;
  return Frames(ensemble.positions.data(), {frames, atoms, 3}, self);
}

void record_ensemble(const SampledEnsemble& self, const std::filesystem::path& path, bool overwrite,
                     bool single, bool compress, double precision, const std::string& save) {
  SampleOutput output = sample_output(path, overwrite, single, compress, precision, save);
  output.options.saved = select_joints(self.model.framework, save, "save");
  const nb::gil_scoped_release no_gil;
  H5mdRecorder recorder(path, self.model.framework, header_for(self.header, output),
                        output.options);
  for (std::size_t k = 0; k < self.frames.size(); ++k) recorder.record(self.frame(k));
  recorder.close();
}

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

}  // namespace

void SampledEnsemble::add(const Frame& frame) {
  positions.insert(positions.end(), frame.positions.begin(), frame.positions.end());
  limits_off.emplace_back(frame.limits_off.begin(), frame.limits_off.end());
  frames.push_back(frame);
}

Frame SampledEnsemble::frame(std::size_t k) const {
  Frame shown = frames[k];
  shown.positions = std::span(positions).subspan(k * atoms(), atoms());
  shown.previous = {};
  shown.limits_off = limits_off[k];
  return shown;
}

SampleOutput sample_output(const std::optional<std::filesystem::path>& path, bool overwrite,
                           bool single, bool compress, double precision, const std::string& save) {
  if (path && path->extension() != ".h5md" && path->extension() != ".h5")
    throw OptionError("output " + path_text(*path) +
                      ": expected a name that ends in .h5md: pliant.sample(..., output=\"" +
                      path_text(path->parent_path() / path->stem()) + ".h5md" + "\").save(\"" +
                      path_text(*path) + "\")");
  return {path,
          {.single = single,
           .compress = compress,
           .precision = precision,
           .overwrite = overwrite,
           .log = unraisable_python_log()},
          save};
}

H5mdHeader header_of_sample(const MolecularModel& model, const AmplitudeChoice& amplitude,
                            const SampleTask& task) {
  H5mdHeader header = header_of(&model.structure);
  header.inputs = sample_inputs(task.start(), task.nodes());
  header.parameters = parameters_of(task.options());
  const std::string file = path_text(path_of(model.structure.source).filename());
  header.parameters.insert(header.parameters.end(),
                           {{"input/file", file},
                            {"sample/amplitude_from", amplitude.source},
                            {"sample/amplitude_reason", amplitude.reason},
                            {"model/kind", std::string(entry(model.kind).name)},
                            left_out_of(model)});
  return header;
}

H5mdHeader header_for(H5mdHeader header, const SampleOutput& output) {
  for (NamedParameter& one : parameters_of(output.options, output.save))
    header.parameters.push_back(std::move(one));
  return header;
}

void bind_sampled_ensemble(nb::module_& module) {
  nb::class_<SampleSummary> summary(module, "SampleSummary", "What sampling did.");
  summary.def_ro("frames", &SampleSummary::frames, "Frames made.");
  bind_summary(summary);
  nb::class_<SampledEnsemble> ensemble(module, "SampledFrames",
                                       "Frames of a molecule, and how exact they are.");
  ensemble.def_ro("model", &SampledEnsemble::model, "What was sampled.")
      .def_prop_ro(
          "amplitude_asked", [](const SampledEnsemble& self) { return self.amplitude.value; },
          "Mean r.m.s. fluctuation of residues that was asked for (Angstrom).")
      .def_prop_ro(
          "amplitude_reason", [](const SampledEnsemble& self) { return self.amplitude.reason; },
          "Origin of the amplitude that was asked for, in words.")
      .def_prop_ro("positions", &sampled_frames, "(F, N, 3) float64 view, Angstrom.")
      .def("record", &record_ensemble, "path"_a, nb::kw_only(), "overwrite"_a = false,
           "single"_a = false, "compress"_a = false, "precision"_a = 0.0, "save"_a = "",
           "Writes the H5MD file that ``sample`` writes with ``output``; options as for\n"
           "``H5mdRecorder``. Raises FileError where it exists or cannot be written.");
  bind_summary(ensemble);
}

}  // namespace pliant::python
