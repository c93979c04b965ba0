// SPDX-License-Identifier: MIT
#include "commands/continue_run.hpp"

#include "command.hpp"
#include "interrupt.hpp"
#include "messages.hpp"
#include "output/print_run.hpp"
#include "pliant/base/error.hpp"
#include "pliant/jobs/continued_run.hpp"
#include "pliant/jobs/run_job.hpp"

namespace pliant::app {

int continue_run(const CommandLine& line, RunSettings& settings) {
  settle_imd(line, settings.imd);
  settings.job.is_live = settings.imd.is_asked;
  settle_walkers(settings.job);
  if (settings.imd.is_asked)
    throw OptionError("--imd: does not go with --continue, which adds to " + settings.job.go_on);
  Messages messages(settings.printing.json || settings.printing.quiet);
  std::optional<std::int64_t> steps;
  if (line.was_given("--steps")) steps = settings.job.run.steps;
  ContinuedRun run(settings.job, steps, "--", messages.log());
  const H5mdCheckpoint& from = run.from();
  check_options_again(
      line, settings.job,
      parameters_of(settings.job, {}, {from.framework, {}}, settings.job.walkers.first), from);
  if (settings.printing.dry_run) return exit_ok;
  watch_for_interrupt();
  std::vector<RunSummary> summaries;
  {
    ProgressBar progress(run.job().walkers.walkers * from.steps / run.job().run.every, "frames",
                         settings.printing.quiet);
    RunWatch watch;
    watch.should_stop = interrupted;
    watch.on_steps = [&progress](std::int64_t frames) { progress.show(frames); };
    summaries = run.run(watch);
  }
  print_run({settings.printing, run.job(), from.framework, {}}, summaries, messages.warnings());
  return exit_code_of(added_up(summaries));
}

}  // namespace pliant::app
