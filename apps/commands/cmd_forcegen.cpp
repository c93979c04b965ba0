// SPDX-License-Identifier: MIT
// pliant lab forcegen: a force file of random pushes (the thesis' ForceGen).
#include <fmt/format.h>

#include <filesystem>
#include <limits>

#include "command.hpp"
#include "messages.hpp"
#include "options/job_options.hpp"
#include "output/json.hpp"
#include "pliant/base/printable.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/jobs/asked/output_options.hpp"
#include "pliant/perturb/force_files/force_file.hpp"
#include "pliant/resolve/resolve.hpp"
#include "pliant/text/compression.hpp"
#include "pliant/text/output_file.hpp"

namespace pliant::app {
namespace {

struct ForcegenSettings {
  MoleculeOptions molecule;
  std::string output;
  std::int64_t count = 50;
  PerturbOptions perturb;
  ResolveOptions resolve;
  bool overwrite = false, json = false;
};

void add_options(CommandLine& line, ForcegenSettings& settings) {
  constexpr auto no_limit = std::numeric_limits<std::int64_t>::max();
  add_molecule_options(line, settings.molecule);
  line.start_group("Pushes");
  line.add_integer("--steps", settings.count, 1, 1'000'000'000, "pushes, one per step");
  line.add_real("--force", settings.perturb.force, Range::zero_or_more,
                "size of each force, kJ/(mol Angstrom); joint and direction are random");
  line.add_seed("--seed", settings.resolve.seed, "seed of all random numbers");
  line.start_group("Settings written for the run");
  line.add_real("--timestep", settings.perturb.timestep, Range::positive, "length of a step, ps");
  line.add_real("--tolerance", settings.resolve.tolerance.relative, Range::positive,
                "largest residual of a whole bar: |length - rest length| / rest length");
  line.add_real("--tolerance-length", settings.resolve.tolerance.length, Range::positive,
                "largest residual in Angstrom, |length - rest length|; replaces --tolerance", "");
  line.add_integer("--max-sweeps", settings.resolve.max_sweeps, 1, no_limit,
                   "give up on a step after this many sweeps");
  line.start_group("Output");
  line.add_text("-o,--output", settings.output, "FILE",
                "force file (default: INPUT's name-forces.txt)");
  line.add_flag("--overwrite", settings.overwrite, "replace an existing file");
  line.add_flag("--json", settings.json, "print one JSON object");
}

ForceFile force_file_of(const ForcegenSettings& settings, const Molecule& molecule) {
  RandomKey key;
  key.seed = settings.resolve.seed;
  ForceFile file = make_force_file(molecule.framework, settings.perturb, settings.resolve.tolerance,
                                   settings.resolve.max_sweeps, key, settings.count);
  file.header = force_header_of(settings.molecule, subject_of(molecule));
  return file;
}

std::string default_output(const std::string& input) {
  const std::filesystem::path name = path_of(input).filename();
  return path_text(without_compression_suffix(name).stem()) + "-forces.txt";
}

void print_summary(const ForcegenSettings& settings) {
  if (!settings.json)
    return fmt::print("{} pushes in {}\n", settings.count, printable_name(settings.output));
  print_json({{"input", settings.molecule.input.file},
              {"output", settings.output},
              {"pushes", settings.count},
              {"force", settings.perturb.force},
              {"seed", settings.resolve.seed}});
}

}  // namespace

int command_forcegen(const Arguments& arguments) {
  CommandLine line(
      "pliant lab forcegen",
      "Writes a force file: random pushes, each a force on one joint, and the timestep,\n"
      "tolerance and maximum number of sweeps that they are meant for. pliant run makes the\n"
      "same pushes with the same --force and --seed. The file lets techniques, and\n"
      "other programs, be compared under the same forces.");
  line.set_footer(
      "Examples:\n"
      "  pliant lab forcegen graph.xml --steps 50 --force 100 --seed 1 -o forces.txt\n"
      "  pliant run graph.xml --forces forces.txt --technique bfs_cycle");
  ForcegenSettings settings;
  add_options(line, settings);
  line.set_common({"--steps", "--force", "--seed", "--model", "--output"});
  if (const int code = line.parse(arguments); code >= 0) return code;
  if (settings.output.empty()) settings.output = default_output(settings.molecule.input.file);
  refuse_same_files(inputs_of(settings.molecule), {settings.output});
  Messages messages(settings.json);
  const Molecule molecule = load_molecule(settings.molecule, messages.log());
  write_text_file(path_of(settings.output),
                  write_force_file(force_file_of(settings, molecule), molecule.framework),
                  settings.overwrite);
  print_summary(settings);
  return exit_ok;
}

}  // namespace pliant::app
