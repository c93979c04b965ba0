// SPDX-License-Identifier: MIT
// pliant forcegen: a force file of random pushes (the thesis' ForceGen).
#include <fmt/format.h>

#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "messages.hpp"
#include "molecule_input.hpp"
#include "pliant/perturb/force_file.hpp"
#include "pliant/resolve/resolve.hpp"
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

void add_options(CLI::App& app, ForcegenSettings& settings) {
  constexpr auto no_limit = std::numeric_limits<std::int64_t>::max();
  add_molecule_options(app, settings.molecule);
  start_group(app, "Pushes");
  add_integer(app, "--count", settings.count, 1, 1'000'000'000, "pushes, one a step");
  add_real(app, "--force", settings.perturb.force, Range::zero_or_more,
           "size of each, kJ/(mol Angstrom); its direction and its joint are random");
  add_seed(app, "--seed", settings.resolve.seed, "of all random numbers");
  start_group(app, "Settings written for the run");
  add_real(app, "--timestep", settings.perturb.timestep, Range::positive, "of a step, ps");
  add_real(app, "--tolerance", settings.resolve.tolerance.relative, Range::positive,
           "largest |length - rest| / rest of a whole bar");
  add_real(app, "--tolerance-length", settings.resolve.tolerance.length, Range::positive,
           "largest |length - rest| in Angstrom, in place of --tolerance")
      ->default_str("");
  add_integer(app, "--max-sweeps", settings.resolve.max_sweeps, 1, no_limit,
              "sweeps after which a step is given up");
  start_group(app, "Output");
  app.add_option("-o,--output", settings.output, "force file (default: INPUT's name-forces.txt)")
      ->type_name("FILE");
  app.add_flag("--overwrite", settings.overwrite, "replace an existing file");
  app.add_flag("--json", settings.json, "print one JSON object");
}

ForceFile force_file_of(const ForcegenSettings& settings, const Framework& framework) {
  RandomKey key;
  key.seed = settings.resolve.seed;
  return make_force_file(framework, settings.perturb, settings.resolve.tolerance,
                         settings.resolve.max_sweeps, key, settings.count);
}

std::string default_output(const std::string& input) {
  std::filesystem::path name = std::filesystem::path(input).filename();
  if (name.extension() == ".gz") name = name.stem();
  return name.stem().string() + "-forces.txt";
}

void report(const ForcegenSettings& settings) {
  if (!settings.json) return fmt::print("{} pushes in {}\n", settings.count, settings.output);
  const nlohmann::ordered_json json{{"input", settings.molecule.file},
                                    {"output", settings.output},
                                    {"pushes", settings.count},
                                    {"force", settings.perturb.force},
                                    {"seed", settings.resolve.seed}};
  using Json = nlohmann::ordered_json;
  fmt::print("{}\n", json.dump(2, ' ', false, Json::error_handler_t::replace));
}

}  // namespace

int command_forcegen(const Arguments& arguments) {
  CLI::App app{
      "Writes a force file: random pushes, each a force on one joint, with the timestep,\n"
      "tolerance and most sweeps that they are meant for. They are the pushes that\n"
      "pliant run meets with the same --force and --seed, so that techniques can be\n"
      "compared, and other programs fed, with the very same forces.",
      "pliant forcegen"};
  prepare(app);
  app.footer(
      "Examples:\n"
      "  pliant forcegen graph.xml --count 50 --force 100 --seed 1 -o forces.txt\n"
      "  pliant run graph.xml --forces forces.txt --technique bfs_cycle");
  ForcegenSettings settings;
  add_options(app, settings);
  if (const int code = parse(app, arguments); code >= 0) return code;
  if (settings.output.empty()) settings.output = default_output(settings.molecule.file);
  Messages messages(settings.json);
  const Molecule molecule = load(settings.molecule, messages.log());
  refuse_same_file(settings.molecule.file, settings.output);
  write_text_file(settings.output,
                  write_force_file(force_file_of(settings, molecule.framework), molecule.framework),
                  settings.overwrite);
  report(settings);
  return exit_ok;
}

}  // namespace pliant::app
