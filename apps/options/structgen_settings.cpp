// SPDX-License-Identifier: MIT
#include "options/structgen_settings.hpp"

#include <limits>

#include "pliant/base/choices.hpp"
#include "pliant/resolve/techniques.hpp"

namespace pliant::app {
namespace {

constexpr auto no_limit = std::numeric_limits<std::int64_t>::max();
constexpr std::int64_t most_files = 1'000'000;

// What means something only with, or only without, --test-set.
constexpr const char* of_one[] = {"CLASS", "--number", "--output", "--overwrite"};
constexpr const char* of_set[] = {"--class",     "--graphs",     "--forces",
                                  "--technique", "--weighting",  "--force",
                                  "--timestep",  "--max-sweeps", "--tolerance-length"};

std::string listed(const std::vector<std::string_view>& names) {
  std::string text;
  for (std::string_view name : names) text.append(text.empty() ? "" : ", ").append(name);
  return text;
}

void add_one_options(CommandLine& line, StructgenSettings& settings) {
  line.add_text("CLASS", settings.kind, "NAME", "class of the graph (see below)");
  line.start_group("One graph");
  line.add_text("-o,--output", settings.output, "FILE", "graph XML (default: CLASS.xml)");
  line.add_integer("--number", settings.number, 0, no_limit, "which graph of this class and seed");
  line.add_flag("--overwrite", settings.overwrite, "replace an existing file");
}

void add_size_options(CommandLine& line, GenerateOptions& sizes) {
  line.start_group("Sizes");
  line.add_integer("--depth", sizes.depth, 1, no_limit, "levels of a tree below its root");
  line.add_integer("--children", sizes.children, 1, no_limit,
                   "largest number of children of a joint (the number is random)");
  line.add_integer("--ring", sizes.ring, 3, no_limit,
                   "largest number of joints of a closed chain (the number is random)");
  line.add_integer("--cycles", sizes.cycles, 0, no_limit, "non-tree bars of an n-cycle");
  line.add_integer("--joints", sizes.joints, 0, no_limit,
                   "joints of a tree; 0: as many as --depth and --children give");
  line.add_real("--box", sizes.box, Range::positive,
                "edge of the box that positions are drawn from, Angstrom");
}

void add_set_options(CommandLine& line, StructgenSettings& settings) {
  TestSetOptions& set = settings.set;
  line.start_group("Test set");
  line.add_text("--test-set", settings.directory, "DIR",
                "make a test set in this new or empty folder");
  line.add_names("--class", set.classes, "all", "classes to make, such as tree,2-cycle-path");
  line.add_integer("--graphs", set.graphs, 1, most_files, "graphs of each class");
  line.add_integer("--forces", set.settings.forces, 1, most_files, "random pushes of each graph");
  line.add_names("--technique", set.techniques, "all orderings",
                 "techniques to make folders for, in the classes that each can resolve");
  line.add_reals("--weighting", set.weightings, Range::zero_to_one, "0.5,0.75,1",
                 "weightings of each technique");
}

void add_force_options(CommandLine& line, TestSettings& settings) {
  line.start_group("Forces of a test set");
  line.add_real("--force", settings.force, Range::zero_or_more,
                "size of a push, kJ/(mol Angstrom)");
  line.add_real("--timestep", settings.timestep, Range::positive, "length of a step, ps");
  line.add_real("--tolerance-length", settings.tolerance_length, Range::positive,
                "largest residual of a whole bar, Angstrom");
  line.add_integer("--max-sweeps", settings.max_sweeps, 1, no_limit,
                   "give up on a step after this many sweeps");
}

std::string footer() {
  std::string text = "Classes:\n";
  for (const GraphClass& row : graph_classes())
    text += "  " + std::string(row.name) + std::string(16 - row.name.size(), ' ') +
            std::string(row.summary) + "\n";
  return text +
         "Examples:\n"
         "  pliant lab structgen 2-cycle-path -o graph.xml --seed 7 --ring 12\n"
         "  pliant lab structgen --test-set tests --graphs 20 --forces 50 --seed 1";
}

}  // namespace

void add_structgen_options(CommandLine& line, StructgenSettings& settings) {
  line.set_footer(footer());
  add_one_options(line, settings);
  add_size_options(line, settings.set.settings.sizes);
  line.start_group("Random numbers and output");
  line.add_seed("--seed", settings.set.settings.seed, "seed of all random numbers");
  line.add_flag("--json", settings.json, "print one JSON object");
  add_set_options(line, settings);
  add_force_options(line, settings.set.settings);
}

void complete(const CommandLine& line, StructgenSettings& settings) {
  const bool is_set = !settings.directory.empty();
  if (!is_set && settings.kind.empty())
    throw OptionError("expected a class of graphs (" + listed(names_of(graph_classes())) +
                      ") or --test-set");
  for (const char* name : of_one)
    if (is_set && line.was_given(name))
      throw OptionError(std::string(name) + ": does not go with --test-set");
  for (const char* name : of_set)
    if (!is_set && line.was_given(name))
      throw OptionError(std::string(name) + ": goes with --test-set alone");
  if (settings.output.empty()) settings.output = settings.kind + ".xml";
}

}  // namespace pliant::app
