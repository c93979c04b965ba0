// SPDX-License-Identifier: MIT
#include "output/sample_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "command.hpp"
#include "output/conformations.hpp"
#include "output/json.hpp"
#include "output/sample_lines.hpp"
#include "pliant/base/printable.hpp"
#include "pliant/molecule/selection.hpp"
#include "pliant/sample/pocket/pocket.hpp"

namespace pliant::app {
namespace {

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

void print_conformations(const Conformations& found) {
  fmt::print("rotors          {}{}{}\n", found.rotors.size(), found.rotors.empty() ? "" : ": ",
             listed(found.rotors));
  fmt::print("rings           {}{}{}\n", found.rings.size(), found.rings.empty() ? "" : ": ",
             listed(found.rings));
  if (!found.rigid_rings.empty())
    fmt::print("rigid rings     {}: {}\n", found.rigid_rings.size(), listed(found.rigid_rings));
  if (!found.amines.empty())
    fmt::print("amines          {}: {} inverts\n", found.amines.size(), listed(found.amines));
  if (!found.amides.empty())
    fmt::print("amides          {}: {} cis or trans\n", found.amides.size(), listed(found.amides));
  if (!found.atropisomers.empty())
    fmt::print("atropisomers    {}: {} keeps its handedness\n", found.atropisomers.size(),
               listed(found.atropisomers));
  if (found.loop_bodies > 0)
    fmt::print("flexible loops  of {} rigid units, {}\n", found.loop_bodies,
               found.are_loops_drawn ? "drawn and closed" : "bent at random");
  fmt::print("                conformers show what is possible; how often is not claimed\n");
}

void print_amplitude(const SampledSystem& system, const SampleSummary& summary) {
  if (summary.near_frames < summary.frames)
    fmt::print(
        "                {} around the structure, as amplitude and RMSF are; {} go further\n",
        summary.near_frames, summary.frames - summary.near_frames);
  if (summary.near_frames == 0) return;
  if (summary.amplitude_asked > 0.0) {
    fmt::print("amplitude       asked {:.2f} A, reached {:.2f} A: an input, not a prediction\n",
               summary.amplitude_asked, summary.amplitude_reached);
    fmt::print("                asked: {}\n", printable_name(system.amplitude.reason));
  } else {
    fmt::print("amplitude       {:.2f} A: how far domains turn is drawn\n",
               summary.amplitude_reached);
  }
  fmt::print("                frames show what can move; how often they occur is not claimed\n");
}

std::string worst_bar_of(const SampledSystem& system, const SampleSummary& summary) {
  const Framework& framework = system.framework;
  return framework.bar_count() == 0 ? "" : framework.label(framework.bars()[summary.worst_bar]);
}

void print_worst(const SampledSystem& system, const SampleSummary& summary) {
  if (system.framework.bar_count() > 0)
    fmt::print("worst bar       {} off by {:.1e} of its length\n", worst_bar_of(system, summary),
               summary.max_residual);
  fmt::print("worst contact   off by {:.3f} A; worst overlap {:.3f} A\n", summary.max_limit,
             summary.max_overlap);
}

double ms_a_frame(const SampleSummary& summary) {
  return 1e3 * summary.cpu_seconds / double(std::max<std::int64_t>(summary.frames, 1));
}

double mean_of(const std::vector<double>& values) {
  double sum = 0.0;
  for (double value : values) sum += value / double(values.size());
  return sum;
}

std::vector<Json> numbers(const std::vector<double>& values) {
  return {values.begin(), values.end()};
}

void print_all(const Job& job, const SampledSystem& system, const SampleSummary& summary) {
  fmt::print("model           {}: {} atoms, {} bars, {} contacts\n", system.kind,
             system.framework.joint_count(), system.framework.bar_count(), system.contacts);
  const auto conformations = conformations_of(job, system);
  fmt::print("frames          {}{}, sampler {}, seed {}\n", summary.frames,
             job.go_on.empty() ? "" : " added", job.sample.sampler, job.sample.seed);
  conformations ? print_conformations(*conformations) : print_amplitude(system, summary);
  if (const auto residues = pocket_of(job, system); !residues.empty())
    fmt::print("pocket          {} residues: {}\n", residues.size(), listed(residues));
  if (summary.ligand_frames > 0) fmt::print("ligand          {}\n", ligand_text(job, summary));
  if (summary.near_frames > 0)
    fmt::print(
        "RMSF            {:.2f} A over atoms, superposed; {:.2f} A between halves of frames\n",
        mean_of(summary.rmsf), mean_of(summary.rmsf_error));
  fmt::print("drawn again     {} frames; {} more needed a second attempt\n", summary.redrawn,
             std::max<std::int64_t>(0, summary.rescued - summary.redrawn));
  if (summary.mean_let_go > 0.0)
    fmt::print("released        {:.1f} contacts a frame\n", summary.mean_let_go);
  print_worst(system, summary);
  fmt::print("time            {:.2f} s; {:.2f} ms of one core per frame\n", summary.seconds,
             ms_a_frame(summary));
  if (summary.failed > 0)
    fmt::print("not resolved    {} frames, which are left out\n", summary.failed);
  if (summary.stopped_by_caller) fmt::print("stopped early; all recorded frames are complete\n");
  if (job.output.topology != "none")
    fmt::print("topology        {}\n", printable_name(job.output.topology));
  fmt::print("trajectory      {}\n", printable_name(job.output.output));
}

void print_json_of(const Job& job, const SampledSystem& system, const SampleSummary& summary,
                   const std::vector<std::string>& warnings) {
  const Conformations moving = conformations_of(job, system).value_or(Conformations{});
  const Json json{{"input", job.molecule.input.file},
                  {"output", job.output.output},
                  {"topology", job.output.topology},
                  {"model", system.kind},
                  {"atoms", system.framework.joint_count()},
                  {"bars", system.framework.bar_count()},
                  {"contacts", system.contacts},
                  {"sampler", job.sample.sampler},
                  {"frames", summary.frames},
                  {"near_frames", summary.near_frames},
                  {"amplitude_asked", summary.amplitude_asked},
                  {"amplitude_reached", summary.amplitude_reached},
                  {"amplitude_is_input", true},
                  {"amplitude_from", system.amplitude.source},
                  {"amplitude_reason", system.amplitude.reason},
                  {"rotors", moving.rotors},
                  {"rings", moving.rings},
                  {"rigid_rings", moving.rigid_rings},
                  {"amines", moving.amines},
                  {"amides", moving.amides},
                  {"atropisomers", moving.atropisomers},
                  {"loop_units", moving.loop_bodies},
                  {"pocket", pocket_of(job, system)},
                  {"ligand_frames", summary.ligand_frames},
                  {"let_go_mean", summary.mean_let_go},
                  {"redrawn", summary.redrawn},
                  {"rescued", summary.rescued},
                  {"failed", summary.failed},
                  {"worst_residual", summary.max_residual},
                  {"worst_bar", worst_bar_of(system, summary)},
                  {"worst_limit", summary.max_limit},
                  {"worst_overlap", summary.max_overlap},
                  {"worst_closing", summary.max_closing},
                  {"off_target", summary.mean_off_target},
                  {"steps_mean", summary.mean_steps},
                  {"rmsf", Json::array(numbers(summary.rmsf))},
                  {"rmsf_error", Json::array(numbers(summary.rmsf_error))},
                  {"stopped_early", summary.stopped_by_caller},
                  {"seconds", summary.seconds},
                  {"cpu_ms_per_frame", ms_a_frame(summary)},
                  {"notes", system.notes},
                  {"missing", system.missing},
                  {"left_out", system.left_out},
                  {"warnings", warnings}};
  print_json(json);
}

}  // namespace

std::vector<std::string> pocket_of(const Job& job, const SampledSystem& system) {
  if (job.sample.around.empty()) return {};
  const auto joints = select_joints(system.framework, job.sample.around, "--around");
  return pliant::names_of(pocket_around(system.framework, system.start, joints), system.framework);
}

void print_sample(const Printing& printing, const Job& job, const SampledSystem& system,
                  const SampleSummary& summary, const std::vector<std::string>& warnings) {
  if (printing.json) {
    print_json_of(job, system, summary, warnings);
  } else if (!printing.quiet) {
    (printing.verbose ? print_all : print_sample_lines)(job, system, summary);
  }
}

int exit_code_of(const SampleSummary& summary) {
  if (summary.stopped_by_caller) return exit_interrupted;
  return summary.failed > 0 ? exit_unconverged : exit_ok;
}

}  // namespace pliant::app
