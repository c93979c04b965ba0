// SPDX-License-Identifier: MIT
#include "print_run.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "command.hpp"
#include "json.hpp"
#include "pliant/base/printable.hpp"
#include "pliant/resolve/automatic.hpp"
#include "pliant/resolve/techniques.hpp"

namespace pliant::app {
namespace {
/// Of the walkers that were begun: each shows at least its start, or has no more to do.
std::vector<std::string> outputs_of(const RunSettings& settings,
                                    const std::vector<RunSummary>& summaries) {
  std::vector<std::string> outputs;
  for (std::size_t k = 0; k < summaries.size(); ++k)
    if (summaries[k].frames > 0 || !summaries[k].stopped_by_caller)
      outputs.push_back(output_of(settings, settings.first_walker + std::int64_t(k)));
  return outputs;
}

std::string worst_bar_of(const Framework& framework, const RunSummary& summary) {
  if (framework.bar_count() == 0) return "";
  return framework.label(framework.bars()[summary.worst_bar]);
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

Json run_json(const RunSettings& settings, const Framework& framework,
              const std::vector<RunSummary>& summaries, const std::vector<std::string>& warnings) {
  const RunSummary summary = added_up(summaries);
  return {{"input", settings.molecule.file},
          {"outputs", outputs_of(settings, summaries)},
          {"topology", settings.topology},
          {"technique", settings.run.technique.name},
          {"technique_used", technique_used(framework, settings.run.technique).name},
          {"weighting", settings.run.technique.weighting},
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

}  // namespace

RunSummary added_up(const std::vector<RunSummary>& summaries) {
  RunSummary sum = summaries.front();
  for (std::size_t k = 1; k < summaries.size(); ++k) {
    const RunSummary& one = summaries[k];
    sum.steps += one.steps;
    sum.frames += one.frames;
    sum.sweeps += one.sweeps;
    sum.projections += one.projections;
    sum.unconverged_steps += one.unconverged_steps;
    if (sum.first_unconverged_step < 0) sum.first_unconverged_step = one.first_unconverged_step;
    sum.max_sweeps = std::max(sum.max_sweeps, one.max_sweeps);
    sum.seconds += one.seconds;
    sum.perturb_seconds += one.perturb_seconds;
    sum.resolve_seconds += one.resolve_seconds;
    sum.observe_seconds += one.observe_seconds;
    sum.stopped_by_caller = sum.stopped_by_caller || one.stopped_by_caller;
    if (one.worst_residual <= sum.worst_residual) continue;
    sum.worst_residual = one.worst_residual;
    sum.worst_bar = one.worst_bar;
    sum.worst_step = one.worst_step;
  }
  return sum;
}

int exit_code_of(const RunSummary& summary) {
  if (summary.stopped_by_caller) return exit_interrupted;
  return summary.unconverged_steps > 0 ? exit_unconverged : exit_ok;
}

void print_run_table(const RunSettings& settings, const Framework& framework,
                     const std::vector<RunSummary>& summaries) {
  const RunSummary summary = added_up(summaries);
  fmt::print("technique       {}\n", technique_line(settings.run.technique, framework));
  fmt::print("steps           {}, of which {} frames are recorded{}\n", summary.steps,
             summary.frames, settings.go_on.empty() ? " (the start is one)" : "");
  fmt::print("sweeps a step   {:.1f} on average, {} at most\n", summary.mean_sweeps(),
             summary.max_sweeps);
  fmt::print("worst bar       {} off by {:.2e} of its length, after step {}\n",
             worst_bar_of(framework, summary), summary.worst_residual, summary.worst_step);
  fmt::print("time            {:.2f} s, {:.0f} us a step; resolving {:.1f} ns a bar and sweep\n",
             summary.seconds, microseconds_per_step(summary), summary.ns_per_bar_and_sweep());
  if (summary.unconverged_steps > 0)
    fmt::print("not converged   {}\n", unconverged_text(summary, starts_left_broken(summaries)));
  if (summary.stopped_by_caller) fmt::print("stopped early; what was recorded is whole\n");
  if (settings.topology != "none")
    fmt::print("topology        {}\n", printable_name(settings.topology));
  for (const std::string& output : outputs_of(settings, summaries))
    fmt::print("trajectory      {}\n", printable_name(output));
}

void print_run_json(const RunSettings& settings, const Framework& framework,
                    const std::vector<RunSummary>& summaries,
                    const std::vector<std::string>& warnings) {
  print_json(run_json(settings, framework, summaries, warnings));
}

void print_run_json(const RunSettings& settings, const Framework& framework,
                    const std::vector<RunSummary>& summaries,
                    const std::vector<std::string>& warnings, const GuideEnd& end) {
  const Json json = run_json(settings, framework, summaries, warnings);
  print_json(settings.guide.empty() ? json : json + end.json());
}

}  // namespace pliant::app
