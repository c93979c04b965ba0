// SPDX-License-Identifier: MIT
// pliant run: the main job. A molecule in, an H5MD trajectory out.
#include <functional>
#include <memory>
#include <optional>

#include "command.hpp"
#include "commands/continue_run.hpp"
#include "interrupt.hpp"
#include "messages.hpp"
#include "options/run_settings.hpp"
#include "output/print_run.hpp"
#include "pliant/jobs/run_job.hpp"

namespace pliant::app {
namespace {

/// Bars of bonds leave a molecule far more freedom than it has.
void tell_what_is_free(const MoleculeOptions& options, const Structure& structure, const Log& log) {
  const bool is_molecule =
      structure.format != "graph" && usual_model(structure) == ModelKind::protein;
  if (is_molecule && options.model.model.empty() && bars_of(options) == "bonds")
    log.note(
        "only bonds are held: angles and planar groups are free, contacts may break, atoms may "
        "overlap; --model protein prevents this, and pliant sample makes ensembles");
}

/// Null where nobody looks.
std::unique_ptr<LiveRun> live_run(const RunSettings& settings, const Job& job,
                                  const Molecule& molecule, const Log& log) {
  if (!settings.imd.is_asked) return nullptr;
  if (job.walkers.record_forces.empty())
    log.warn("clients can pull, but a force file cannot describe this run: it cannot be repeated");
  return std::make_unique<LiveRun>(settings.imd, job.run, molecule.framework.joint_count(), log);
}

/// Ctrl-C, and clients, who may end the run.
std::function<bool()> stops_of(LiveRun* live) {
  return [live] { return interrupted() || (live != nullptr && live->was_killed()); };
}

/// `last` receives the positions of a single walker.
RunWatch watch_of(const RunSettings& settings, const Job& job, LiveRun* live, ProgressBar& progress,
                  std::vector<Vec3>& last) {
  RunWatch watch;
  watch.should_stop = stops_of(live);
  watch.on_steps = [&progress](std::int64_t steps) { progress.show(steps); };
  watch.on_end = [live, &last](std::int64_t, const State& state) {
    if (live != nullptr) live->finish();
    last = state.positions;
  };
  if (live == nullptr) return watch;
  watch.observers_of = [&settings, &job, live](std::int64_t) {
    // A port that nobody chose has to be said.
    if (!settings.printing.quiet || settings.imd.port == 0) live->say_where(job.output.topology);
    return std::vector<Observer>();
  };
  watch.hands = live->hands();
  watch.onlooker = live->onlooker();
  watch.was_pulled = [live] { return live->was_pulled(); };
  return watch;
}

constexpr const char* footer =
    "Examples:\n"
    "  pliant run caffeine.sdf\n"
    "  pliant run protein.pdb -o out.h5md --steps 10000 --every 10 --technique blocks\n"
    "  pliant run protein.pdb -o movie.pdb --every 10\n"
    "  pliant run protein.pdb --perturb displacement --pin \"chainID A\" --walkers 8\n"
    "  pliant run protein.pdb --model protein --rock 1 --amplitude 2\n"
    "  pliant run protein.pdb --model protein --pull \"resid 30:40\" 0,0,8\n"
    "  pliant run protein.pdb --model protein \\\n"
    "      --pair-distance \"resid 12 and name CA\" \"resid 88 and name CA\" 20..25\n"
    "  pliant run --continue out.h5md                after its end, Ctrl-C or a crash\n"
    "  pliant run --continue out.h5md --steps 20000\n"
    "Exit codes: 0 done, 1 bad input or file, 2 bad option, 3 a step did not converge or a\n"
    "guide did not reach its goal, 130 ended early by Ctrl-C, with all frames complete.";

int code_of(const std::vector<RunSummary>& summaries, const GuideEnd& end) {
  const int code = exit_code_of(added_up(summaries));
  return code == exit_ok && !end.is_reached() ? exit_unconverged : code;
}

int run(const RunSettings& settings, RunJob& run, const Molecule& molecule, Messages& messages) {
  const Job& job = run.job();
  watch_for_interrupt();
  std::vector<Vec3> last = molecule.structure.positions;
  const auto live = live_run(settings, job, molecule, messages.log());
  std::vector<RunSummary> summaries;
  {
    ProgressBar progress(job.walkers.walkers * job.run.steps, "steps", settings.printing.quiet);
    summaries = run.run(State(last), watch_of(settings, job, live.get(), progress, last));
  }
  std::optional<ImdSummary> served;
  if (live) served = live->close();
  const GuideEnd end(job.guide, job.run.guide, molecule.structure.positions, last);
  print_run({settings.printing, job, molecule.framework, run.replayed()}, summaries,
            messages.warnings(), &end, served);
  return code_of(summaries, end);
}

int begin(const CommandLine& line, RunSettings& settings) {
  Job& asked = settings.job;
  const bool asks_for_topology = !asked.output.topology.empty();
  settle_imd(line, settings.imd);
  asked.is_live = settings.imd.is_asked;
  settle_walkers(asked);
  name_outputs(asked.output, asked.molecule.input.file, asked.walkers.first == 0);
  RunJob job(asked, "--");
  Messages messages(settings.printing.json || settings.printing.quiet);
  const MoleculeOptions& input = job.job().molecule;
  const Molecule molecule =
      load_molecule(input, messages.log_of_model(input.input.file, settings.printing.verbose));
  messages.end_model(molecule.left_out);
  tell_what_is_free(input, molecule.structure, messages.log());
  job.take(subject_of(molecule), messages.log());
  job.fit_topology(asks_for_topology);
  if (settings.printing.dry_run)
    return print_forces(settings.printing, job.job(), job.replayed()), exit_ok;
  return run(settings, job, molecule, messages);
}

}  // namespace

int command_run(const Arguments& arguments) {
  CommandLine line(
      "pliant run",
      "Pushes a molecule again and again, restores what each push breaks, and records every\n"
      "step in an H5MD trajectory.\n"
      "\n"
      "Atoms are joints. A bar is two joints at a fixed distance: a bond or, with --bars\n"
      "angles, the two ends of a bond angle. A push breaks bars. A technique resolves them:\n"
      "it makes them whole again, each at its length within the tolerance. Most techniques\n"
      "do so in sweeps, visits to all bars one after another. How far a bar is off is its\n"
      "residual; if one is beyond the tolerance, the frame and the exit code (3) say so. A\n"
      "walker is one of several independent copies of the molecule.");
  line.set_footer(footer);
  RunSettings settings;
  add_job_options(line, settings.job);
  add_printing_options(line, settings.printing);
  add_imd_options(line, settings.imd);
  line.set_common(
      {"--model", "--steps", "--technique", "--perturb", "--pull", "--pair-distance", "--output"});
  if (const int code = line.parse(arguments); code >= 0) return code;
  return with_errors_as_json(!settings.printing.job_file.empty(), [&] {
    take_job_file(line, settings.job, settings.printing.job_file);
    note_given(line, settings.job);
    return settings.job.go_on.empty() ? begin(line, settings) : continue_run(line, settings);
  });
}

}  // namespace pliant::app
