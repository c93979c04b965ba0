// SPDX-License-Identifier: MIT
// pliant sample: an ensemble of what a molecule can do. A molecule in, an H5MD trajectory out.
#include <algorithm>

#include "command.hpp"
#include "interrupt.hpp"
#include "messages.hpp"
#include "options/job_options.hpp"
#include "output/sample_report.hpp"
#include "pliant/base/error.hpp"
#include "pliant/base/printable.hpp"
#include "pliant/jobs/files/frame_output.hpp"
#include "pliant/jobs/sample_job.hpp"
#include "pliant/molecule/read/read.hpp"

namespace pliant::app {
namespace {

struct SampleSettings {
  Job job = usual_job("sample");
  Printing printing;
};

/// An SDF file is what `pliant conformers` makes, ranked, of all records.
void refuse_ranking(const Job& job) {
  if (is_sdf_name(job.output.output) && job.sample.sampler == automatic_sampler)
    throw OptionError("--output " + job.output.output +
                      ": pliant conformers writes SDF, ranked by energy; --sampler torsions writes "
                      "all frames of one molecule");
}

/// Counts frames on the progress bar until Ctrl-C.
SampleObserver counted(ProgressBar& progress) {
  return [&progress, done = std::int64_t{0}](const Frame&) mutable {
    progress.show(++done);
    return interrupted();
  };
}

int go_on(const CommandLine& line, SampleSettings& settings) {
  settle_amplitude(settings.job.sample.amplitude_from);
  Messages messages(settings.printing.json || settings.printing.quiet);
  std::optional<std::int64_t> frames;
  if (line.was_given("--frames")) frames = settings.job.sample.frames;
  ContinuedSample sample(settings.job, frames, "--", messages.log());
  check_options_again(line, settings.job, parameters_of(settings.job), sample.from());
  if (settings.printing.dry_run) return exit_ok;
  watch_for_interrupt();
  ProgressBar progress(sample.from().steps - sample.from().done, "frames", settings.printing.quiet);
  const SampleSummary summary = sample.run(counted(progress), interrupted);
  print_sample(settings.printing, sample.job(), sample.system(), summary, messages.warnings());
  return exit_code_of(summary);
}

/// Of several records one is taken only if it was asked for.
void refuse_library(const CommandLine& line, const Structure& structure) {
  if (is_from(structure, &Format::has_small_molecules) && structure.model_count > 1 &&
      !line.was_given("--frame"))
    throw OptionError(printable_name(structure.source) + ": holds " +
                      std::to_string(structure.model_count) +
                      " molecules: pliant conformers makes conformers of all; --frame N takes one");
}

int begin(const CommandLine& line, SampleSettings& settings) {
  Job& job = settings.job;
  const bool asks_for_topology = !job.output.topology.empty();
  refuse_ranking(job);
  settle_sample(job);
  Messages messages(settings.printing.json || settings.printing.quiet);
  const Log log = messages.log_of_model(job.molecule.input.file, settings.printing.verbose);
  const Structure structure = read_input(job.molecule.input, log);
  refuse_library(line, structure);
  MolecularModel model = sampled_model(job, structure, std::nullopt, "--", log);
  messages.end_model({});  // the report says what is left out
  SampleJob sample(job, std::move(model), "--", messages.log());
  sample.fit_topology(asks_for_topology);
  if (settings.printing.dry_run) return exit_ok;
  watch_for_interrupt();
  ProgressBar progress(sample.job().sample.frames, "frames", settings.printing.quiet);
  const SampleSummary summary = sample.run(counted(progress), interrupted);
  warn_of_amplitude(summary, messages.log());
  print_sample(settings.printing, sample.job(), sample.system(), summary, messages.warnings());
  return exit_code_of(summary);
}

constexpr const char* sample_purpose =
    "Makes an ensemble: independent frames around the structure in the file, each with exact\n"
    "bonds and angles and no overlaps. Contacts are held. In about half of the frames of a\n"
    "larger protein (see --sampler) domains turn, and contacts between them are released.\n"
    "How far the frames go (--amplitude) is an input, not a prediction, and how often a shape\n"
    "occurs is not known.\n"
    "For a small molecule the frames are conformers, with new torsions and flipped rings.";

constexpr const char* sample_examples =
    "Examples:\n"
    "  pliant sample protein.pdb -o ensemble.h5md\n"
    "  pliant sample protein.cif --frames 1000 --amplitude 2 --seed 7\n"
    "  pliant sample protein.pdb --amplitude nmr_models.pdb\n"
    "  pliant sample protein.pdb --sampler dilute --hbond-cutoff -2\n"
    "  pliant sample drug.sdf --frames 200                 torsions, rings; ranked ones: pliant "
    "conformers\n"
    "  pliant sample --continue ensemble.h5md              after Ctrl-C or a crash\n"
    "  pliant sample --continue ensemble.h5md --frames 2000\n"
    "Exit codes: 0 done, 1 bad input or file, 2 bad option, 3 a frame could not be made and\n"
    "is left out, 130 ended early by Ctrl-C, with all frames complete.";

}  // namespace

int command_sample(const Arguments& arguments) {
  CommandLine line("pliant sample", sample_purpose);
  line.set_footer(sample_examples);
  SampleSettings settings;
  add_job_options(line, settings.job);
  add_printing_options(line, settings.printing);
  line.set_common({"--frames", "--amplitude", "--continue", "--select", "--keep", "--output"});
  if (const int code = line.parse(arguments); code >= 0) return code;
  return with_errors_as_json(!settings.printing.job_file.empty(), [&] {
    take_job_file(line, settings.job, settings.printing.job_file);
    return settings.job.go_on.empty() ? begin(line, settings) : go_on(line, settings);
  });
}

}  // namespace pliant::app
