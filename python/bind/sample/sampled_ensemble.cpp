// SPDX-License-Identifier: MIT
#include "sample/sampled_ensemble.hpp"

#include <nanobind/stl/filesystem.h>

#include <utility>

#include "arrays.hpp"
#include "messages.hpp"
#include "option_fields.hpp"
#include "pliant/base/error.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/jobs/sample_checkpoint.hpp"
#include "pliant/model/model.hpp"
#include "pliant/molecule/selection.hpp"

namespace pliant::python {
namespace {

FramesView sampled_frames(nb::handle_t<SampledEnsemble> self) {
  auto& ensemble = nb::cast<SampledEnsemble&>(self);
  const std::size_t atoms = ensemble.atoms();
  const std::size_t frames = atoms == 0 ? 0 : ensemble.positions.size() / atoms;
  return FramesView(ensemble.positions.data(), {frames, atoms, 3}, self);
}

void record_ensemble(const SampledEnsemble& self, const std::filesystem::path& path,
                     const nb::kwargs& more) {
  nb::dict given(more);
  OutputOptions output = take_output(given);
  refuse_unknown(nb::type<SampledEnsemble>().attr("record"), nb::make_tuple(nb::none()), given);
  output.record.saved = select_joints(self.model.framework, output.save, "save");
  H5mdHeader header = self.header;
  for (auto& [place, value] : header.parameters)
    for (const auto& field : output_fields())
      if (place == recorded_path("record", field)) value = parameter_of(field, field.place(output));
  const nb::gil_scoped_release no_gil;
  H5mdRecorder recorder(path, self.model.framework, header, output.record);
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
          "ligand_frames", [](const T& self) { return summary_of(self).ligand_frames; },
          "Frames in which the ligand of ``around`` has other torsions.")
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

/// How a file of frames in memory is recorded.
std::string record_signature() {
  std::string text = "def record(self, path: str | os.PathLike[str], *";
  OutputOptions usual;
  for (const auto& field : output_fields())
    if (field.users.python && field.name != "output" && field.name != "topology")
      text += ", " + argument_text(field, field.place(usual));
  return text + ") -> None";
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

OutputOptions take_output(nb::dict given) {
  OutputOptions output;
  take_values(output_fields(), given, output);
  output.record.log = unraisable_python_log();
  const std::filesystem::path path = path_of(output.output);
  if (!path.empty() && path.extension() != ".h5md" && path.extension() != ".h5")
    throw OptionError("output " + output.output +
                      ": expected a name that ends in .h5md: pliant.sample(..., output=\"" +
                      path_text(path.parent_path() / path.stem()) + ".h5md" + "\").save(\"" +
                      output.output + "\")");
  return output;
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
      .def("record", &record_ensemble, "path"_a, "options"_a, nb::sig(record_signature().c_str()),
           "Writes the H5MD file that ``sample`` writes with ``output``; options as for\n"
           "``H5mdRecorder``. Raises FileError where it exists or cannot be written.");
  bind_summary(ensemble);
}

}  // namespace pliant::python
