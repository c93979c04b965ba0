// SPDX-License-Identifier: MIT
#include "structgen_settings.hpp"

#include <limits>

#include "pliant/resolve/techniques.hpp"

namespace pliant::app {
namespace {

constexpr auto no_limit = std::numeric_limits<std::int64_t>::max();
constexpr std::int64_t most_files = 1'000'000;

// What means something only with, or only without, --test-set.
constexpr const char* of_one[] = {"CLASS", "--number", "--output", "--overwrite"};
constexpr const char* of_set[] = {"--classes",    "--graphs",          "--forces", "--force-files",
                                  "--techniques", "--weightings",      "--force",  "--timestep",
                                  "--max-sweeps", "--tolerance-length"};

std::string listed(const std::vector<std::string_view>& names) {
  std::string text;
  for (std::string_view name : names) text.append(text.empty() ? "" : ", ").append(name);
  return text;
}

void add_one_options(CLI::App& app, StructgenSettings& settings) {
  app.add_option("CLASS", settings.kind, "class of the graph: see below")->type_name("NAME");
  start_group(app, "One graph");
  app.add_option("-o,--output", settings.output, "graph XML (default: CLASS.xml)")
      ->type_name("FILE");
  add_integer(app, "--number", settings.number, 0, no_limit,
              "which of all graphs of the class and seed");
  app.add_flag("--overwrite", settings.overwrite, "replace an existing file");
}

void add_size_options(CLI::App& app, GenerateOptions& sizes) {
  start_group(app, "Sizes");
  add_integer(app, "--depth", sizes.depth, 1, no_limit, "levels of a tree below its root");
  add_integer(app, "--children", sizes.children, 1, no_limit,
              "most children of a joint; the number is random");
  add_integer(app, "--ring", sizes.ring, 3, no_limit,
              "most joints of a closed chain; the number is random");
  add_integer(app, "--cycles", sizes.cycles, 0, no_limit, "non-tree bars of an n-cycle");
  add_integer(app, "--joints", sizes.joints, 0, no_limit,
              "joints of a tree; 0: as --depth and --children have it");
  add_real(app, "--box", sizes.box, Range::positive,
           "edge of the box that positions are drawn from, Angstrom");
}

void add_set_options(CLI::App& app, StructgenSettings& settings) {
  TestSetOptions& set = settings.set;
  start_group(app, "Test set");
  app.add_option("--test-set", settings.directory, "make a test set in this new or empty folder")
      ->type_name("DIR");
  add_names(app, "--classes", set.classes, "all", "classes to make, such as tree,2-cycle-path");
  add_integer(app, "--graphs", set.graphs, 1, most_files, "graphs of each class");
  add_integer(app, "--forces", set.settings.forces, 1, most_files, "random pushes of each graph");
  add_integer(app, "--force-files", set.force_files, 1, most_files,
              "files that the pushes of a graph are spread over");
  add_names(app, "--techniques", set.techniques, "all orderings",
            "techniques to make folders for, each for the classes that it resolves");
  add_reals(app, "--weightings", set.weightings, Range::zero_to_one, "0.5,0.75,1",
            "weightings of each technique");
}

void add_force_options(CLI::App& app, TestSettings& settings) {
  start_group(app, "Forces of a test set");
  add_real(app, "--force", settings.force, Range::zero_or_more,
           "size of a push, kJ/(mol Angstrom)");
  add_real(app, "--timestep", settings.timestep, Range::positive, "of a step, ps");
  add_real(app, "--tolerance-length", settings.tolerance_length, Range::positive,
           "largest |length - rest| of a whole bar, Angstrom");
  add_integer(app, "--max-sweeps", settings.max_sweeps, 1, no_limit,
              "sweeps after which a step is given up");
}

std::string footer() {
  std::string text = "Classes:\n";
  for (const GraphClass& row : graph_classes())
    text += "  " + std::string(row.name) + std::string(16 - row.name.size(), ' ') +
            std::string(row.summary) + "\n";
  return text +
         "Examples:\n"
         "  pliant structgen 2-cycle-path -o graph.xml --seed 7 --ring 12\n"
         "  pliant structgen --test-set tests --graphs 20 --forces 50 --seed 1";
}

}  // namespace

void add_structgen_options(CLI::App& app, StructgenSettings& settings) {
  app.footer(footer());
  add_one_options(app, settings);
  add_size_options(app, settings.set.settings.sizes);
  start_group(app, "Random numbers and output");
  add_seed(app, "--seed", settings.set.settings.seed, "of all random numbers");
  app.add_flag("--json", settings.json, "print one JSON object");
  add_set_options(app, settings);
  add_force_options(app, settings.set.settings);
}

void complete(const CLI::App& app, StructgenSettings& settings) {
  const bool is_set = !settings.directory.empty();
  if (!is_set && settings.kind.empty())
    throw OptionError("expected a class of graphs (" + listed(names_of(graph_classes())) +
                      ") or --test-set");
  for (const char* name : of_one)
    if (is_set && app.count(name) > 0)
      throw OptionError(std::string(name) + ": does not go with --test-set");
  for (const char* name : of_set)
    if (!is_set && app.count(name) > 0)
      throw OptionError(std::string(name) + ": goes with --test-set alone");
  if (settings.output.empty()) settings.output = settings.kind + ".xml";
}

}  // namespace pliant::app
