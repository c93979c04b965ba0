// SPDX-License-Identifier: MIT
#include "output/print_run.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "command.hpp"
#include "output/json.hpp"
#include "pliant/base/printable.hpp"
#include "pliant/jobs/run_outputs.hpp"
#include "pliant/resolve/auto.hpp"
#include "pliant/resolve/techniques.hpp"

namespace pliant::app {
namespace {
/// The files of the walkers that were begun: each shows at least its start, or has no more to do.
std::vector<std::string> outputs_of(const Job& job, const std::vector<RunSummary>& summaries) {
  if (job.walkers.one_file) return {job.output.output};
  std::vector<std::string> outputs;
  for (std::size_t k = 0; k < summaries.size(); ++k)
    if (summaries[k].frames > 0 || !summaries[k].stopped_by_caller)
      outputs.push_back(output_of(job, job.walkers.first + std::int64_t(k)));
  return outputs;
}

std::string worst_bar_of(const Framework& framework, const RunSummary& summary) {
  if (framework.bar_count() == 0) return "";
  const bool is_known = summary.worst_joints.a != summary.worst_joints.b;
  return framework.label(is_known ? summary.worst_joints : framework.bars()[summary.worst_bar]);
}

/// "auto: blocks (the bars close no cycle: ...)", "bfs_cycle, weighting 0.5", "blocks".
std::string technique_line(const Technique& technique, const Framework& framework) {
  if (technique.name == "auto") {
    const Choice choice = choose_technique(framework, technique);
    return fmt::format("auto: {} ({})", choice.technique.name, choice.why);
  }
  if (!find_technique(technique.name).has_weighting) return technique.name;
  return fmt::format("{}, weighting {}", technique.name, technique.weighting);
}

double microseconds_per_step(const RunSummary& summary) {
  return summary.steps > 0 ? 1e6 * summary.seconds / double(summary.steps) : 0.0;
}

/// Walkers whose start, which is no step, could not be made whole.
std::int64_t starts_left_broken(const std::vector<RunSummary>& summaries) {
  return std::count_if(summaries.begin(), summaries.end(),
                       [](const RunSummary& one) { return one.first_unconverged_step == 0; });
}

/// "3 of 20 steps, the first is step 5"; "20 of 20 steps, and the start".
std::string unconverged_text(const RunSummary& summary, std::int64_t starts) {
  std::string text =
      fmt::format("{} of {} steps", summary.unconverged_steps - starts, summary.steps);
  if (starts == 0)
    return text + fmt::format(", the first is step {}", summary.first_unconverged_step);
  return text + (starts == 1 ? ", and the start" : fmt::format(", and {} starts", starts));
}

Json run_json(const RunReport& report, const std::vector<RunSummary>& summaries,
              const std::vector<std::string>& warnings) {
  const Job& job = report.job;
  const Framework& framework = report.framework;
  const RunSummary summary = added_up(summaries);
  return {{"input", job.molecule.input.file},
          {"outputs", outputs_of(job, summaries)},
          {"topology", job.output.topology},
          {"technique", job.run.technique.name},
          {"technique_used", technique_used(framework, job.run.technique).name},
          {"weighting", job.run.technique.weighting},
          {"atoms", framework.joint_count()},
          {"bars", framework.bar_count()},
          {"steps", summary.steps},
          {"frames", summary.frames},
          {"sweeps_mean", summary.mean_sweeps()},
          {"sweeps_max", summary.max_sweeps},
          {"projections", summary.projections},
          {"worst_residual", summary.worst_residual},
          {"worst_bar", worst_bar_of(framework, summary)},
          {"worst_step", summary.worst_step},
          {"unconverged_steps", summary.unconverged_steps},
          {"stopped_early", summary.stopped_by_caller},
          {"seconds", summary.seconds},
          {"perturb_seconds", summary.perturb_seconds},
          {"resolve_seconds", summary.resolve_seconds},
          {"record_seconds", summary.observe_seconds},
          {"us_per_step", microseconds_per_step(summary)},
          {"ns_per_bar_and_sweep", summary.ns_per_bar_and_sweep()},
          {"warnings", warnings}};
}

/// What the run owes to its force file.
Json forces_json(const Job& job, const ReplayedForces& replayed) {
  std::vector<std::pair<std::string, Json>> taken;
  for (const auto& [name, value] : replayed.taken) taken.emplace_back(name, value);
  return {{"forces", Json{{"file", job.walkers.forces}, {"taken", Json::object(taken)}}}};
}

/// "a.forces: model protein, timestep 0.01".
std::string forces_text(const Job& job, const ReplayedForces& replayed) {
  std::string text;
  for (const auto& [name, value] : replayed.taken)
    text += fmt::format("{} {} {}", text.empty() ? ":" : ",", name, printable_name(value));
  return printable_name(job.walkers.forces) + text;
}

Json served_json(const ImdSummary& served) {
  return {{"imd_clients", served.clients},           {"imd_clients_refused", served.refused},
          {"imd_frames_sent", served.frames_sent},   {"imd_frames_dropped", served.frames_dropped},
          {"imd_forces_taken", served.forces_taken}, {"imd_seconds_waited", served.seconds_waited}};
}

/// What the count of frames includes; a run that goes on has its start in the file already.
const char* with_the_start(const Job& job) {
  if (!job.go_on.empty()) return "";
  return job.walkers.are_several() ? ", with the start of each walker" : ", with the start";
}

void print_table(const RunReport& report, const std::vector<RunSummary>& summaries) {
  const Job& job = report.job;
  const RunSummary summary = added_up(summaries);
  print_forces(report.printing, job, report.replayed);
  fmt::print("technique       {}\n", technique_line(job.run.technique, report.framework));
  fmt::print("steps           {}; {} frames recorded{}\n", summary.steps, summary.frames,
             with_the_start(job));
  fmt::print("sweeps per step {:.1f} on average, {} at most\n", summary.mean_sweeps(),
             summary.max_sweeps);
  fmt::print("worst bar       {} off by {:.2e} of its length, after step {}\n",
             worst_bar_of(report.framework, summary), summary.worst_residual, summary.worst_step);
  fmt::print("time            {:.2f} s, {:.0f} us a step; resolving {:.1f} ns a bar and sweep\n",
             summary.seconds, microseconds_per_step(summary), summary.ns_per_bar_and_sweep());
  if (summary.unconverged_steps > 0)
    fmt::print("not converged   {}\n", unconverged_text(summary, starts_left_broken(summaries)));
  if (summary.stopped_by_caller) fmt::print("stopped early; all recorded frames are complete\n");
  if (job.output.topology != no_topology)
    fmt::print("topology        {}\n", printable_name(job.output.topology));
  for (const std::string& output : outputs_of(job, summaries))
    fmt::print("trajectory      {}\n", printable_name(output));
}

void print_served(const ImdSummary& served) {
  fmt::print("IMD             {} clients, {} frames sent, {} dropped, {} packets of forces\n",
             served.clients, served.frames_sent, served.frames_dropped, served.forces_taken);
  if (served.refused > 0) fmt::print("                {} clients refused\n", served.refused);
  if (served.seconds_waited > 0.0)
    fmt::print("                {:.2f} s waited for clients\n", served.seconds_waited);
}

}  // namespace

RunSummary added_up(const std::vector<RunSummary>& summaries) {
  RunSummary sum = summaries.front();
  for (std::size_t k = 1; k < summaries.size(); ++k) add(sum, summaries[k]);
  return sum;
}

int exit_code_of(const RunSummary& summary) {
  if (summary.stopped_by_caller) return exit_interrupted;
  return summary.unconverged_steps > 0 ? exit_unconverged : exit_ok;
}

void print_forces(const Printing& printing, const Job& job, const ReplayedForces& replayed) {
  if (!replayed.header || printing.quiet) return;
  if (printing.json) return print_json(forces_json(job, replayed));
  fmt::print("force file      {}\n", forces_text(job, replayed));
}

void print_run(const RunReport& report, const std::vector<RunSummary>& summaries,
               const std::vector<std::string>& warnings, const GuideEnd* end,
               const std::optional<ImdSummary>& served) {
  if (report.printing.json) {
    Json json = run_json(report, summaries, warnings);
    if (report.replayed.header) json = json + forces_json(report.job, report.replayed);
    if (served) json = json + served_json(*served);
    print_json(end == nullptr || report.job.guide.empty() ? json : json + end->json());
  } else if (!report.printing.quiet) {
    print_table(report, summaries);
    if (served) print_served(*served);
    if (end != nullptr) end->print();
  }
}

}  // namespace pliant::app
