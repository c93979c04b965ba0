// SPDX-License-Identifier: MIT
#include "pliant/lab/test_sets/make_test_set.hpp"

#include <algorithm>
#include <cmath>

#include "pliant/base/error.hpp"
#include "pliant/base/number.hpp"
#include "pliant/base/printable.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/order/ordering_file.hpp"
#include "pliant/record/xml/write_graph_xml.hpp"
#include "pliant/resolve/resolve.hpp"
#include "pliant/resolve/techniques.hpp"
#include "pliant/text/output_file.hpp"

namespace pliant {
namespace {

namespace fs = std::filesystem;

void expect_from_one(const char* name, std::int64_t value) {
  if (value < 1)
    throw OptionError(std::string(name) + " = " + std::to_string(value) + ": must be from 1");
}

PerturbOptions perturb_options_of(const TestSettings& settings) {
  PerturbOptions options;
  options.force = settings.force;
  options.timestep = settings.timestep;
  return options;
}

void check(const TestSetOptions& options) {
  const TestSettings& settings = options.settings;
  expect_from_one("graphs", options.graphs);
  expect_from_one("forces", settings.forces);
  expect_from_one("force_files", options.force_files);
  if (options.force_files > settings.forces)
    throw OptionError("force_files = " + std::to_string(options.force_files) +
                      ": must be at most the forces, " + std::to_string(settings.forces));
  if (!(settings.tolerance_length > 0.0 && std::isfinite(settings.tolerance_length)))
    throw OptionError("tolerance_length = " + number_text(settings.tolerance_length) +
                      ": must be positive and finite");
  pliant::check(settings.sizes);
  pliant::check(perturb_options_of(settings));
  ResolveOptions resolve;
  resolve.max_sweeps = settings.max_sweeps;
  pliant::check(resolve);
  for (const std::string& name : options.techniques) find_technique(name);
  for (double weighting : options.weightings) pliant::check(Technique{"random", weighting});
}

/// The classes, each once, in the order given.
std::vector<const GraphClass*> classes_of(const TestSetOptions& options) {
  std::vector<const GraphClass*> rows;
  for (const std::string& name : options.classes) {
    const GraphClass* row = &find_graph_class(name);
    if (std::find(rows.begin(), rows.end(), row) != rows.end())
      throw OptionError("classes: " + name + " is given twice");
    rows.push_back(row);
  }
  if (rows.empty())
    for (const GraphClass& row : graph_classes()) rows.push_back(&row);
  return rows;
}

std::vector<std::string> techniques_of(const TestSetOptions& options) {
  if (!options.techniques.empty()) return options.techniques;
  std::vector<std::string> names;
  for (const OrderingEntry& row : orderings())
    if (row.name != "input") names.emplace_back(row.name);
  return names;
}

/// The heuristics that resolve the class; one weighting is enough for a technique that has none.
std::deque<TestHeuristic> heuristics_of(const TestSetOptions& options, const GraphClass& kind) {
  std::deque<TestHeuristic> rows;
  const auto add = [&](const std::string& technique, double weighting) {
    const auto same = [&](const TestHeuristic& row) {
      return row.technique == technique && row.weighting == weighting;
    };
    if (std::none_of(rows.begin(), rows.end(), same)) rows.push_back({technique, weighting});
  };
  for (const std::string& technique : techniques_of(options)) {
    const TechniqueEntry& entry = find_technique(technique);
    if (entry.forests_only && kind.family != "tree") continue;
    if (!entry.has_weighting) add(technique, Technique{}.weighting);
    for (double weighting : options.weightings)
      if (entry.has_weighting) add(technique, weighting);
  }
  return rows;
}

/// The pushes of one graph over several files, as evenly as can be.
std::vector<ForceFile> force_files_of(const TestSetOptions& options, const Framework& framework,
                                      const RandomKey& key) {
  const TestSettings& settings = options.settings;
  ForceFile whole = make_force_file(framework, perturb_options_of(settings),
                                    {.length = settings.tolerance_length}, settings.max_sweeps, key,
                                    settings.forces);
  std::vector<ForceFile> files;
  for (std::int64_t k = 0; k < options.force_files; ++k) {
    const auto from = whole.pushes.begin() + k * settings.forces / options.force_files;
    const auto to = whole.pushes.begin() + (k + 1) * settings.forces / options.force_files;
    files.push_back(whole);
    files.back().pushes.assign(from, to);
  }
  return files;
}

Ordering bfs_cycle_of(const Framework& framework) {
  OrderScratch scratch;
  Ordering ordering;
  find_ordering("bfs_cycle").order({.framework = framework}, scratch, ordering);
  return ordering;
}

TestGraph make_graph(const TestSetOptions& options, const GraphClass& kind, std::int64_t number) {
  RandomKey key;
  key.seed = options.settings.seed;
  key.walker = std::uint64_t(number);
  GeneratedGraph made = generate(kind, options.settings.sizes, key);
  TestGraph graph{
      .folder = test_set_paths::graph_folder(kind.name, number),
      .number = number,
      .graph = {std::move(made.framework), std::move(made.positions), std::move(made.cycles)}};
  graph.ordering = bfs_cycle_of(graph.graph.framework);
  graph.force_files = force_files_of(options, graph.graph.framework, key);
  graph.heuristics = heuristics_of(options, kind);
  return graph;
}

void write_graph(const fs::path& directory, const TestGraph& graph) {
  const Framework& framework = graph.graph.framework;
  const fs::path folder = directory / graph.folder;
  make_folder(folder / "heuristics" / "forces");
  write_text_file(folder / test_set_paths::graph_file,
                  write_graph_xml(framework, graph.graph.positions, graph.graph.cycles), false);
  write_text_file(folder / test_set_paths::ordering_file,
                  write_ordering_file(graph.ordering, framework), false);
  for (std::size_t k = 0; k < graph.force_files.size(); ++k)
    write_text_file(directory / test_set_paths::force_file(graph, k),
                    write_force_file(graph.force_files[k], framework), false);
  for (const TestHeuristic& heuristic : graph.heuristics)
    make_folder(directory / test_set_paths::heuristic(graph, heuristic));
}

fs::path new_folder(const fs::path& directory) {
  make_folder(directory);
  std::error_code error;
  if (!fs::is_empty(directory, error) || error)
    throw FileError(printable_name(path_text(directory)) + ": " +
                    (error ? error.message() : "a test set is made in an empty folder"));
  return fs::canonical(directory);
}

}  // namespace

TestSet make_test_set(const fs::path& directory, const TestSetOptions& options) {
  check(options);
  const std::vector<const GraphClass*> kinds = classes_of(options);
  TestSet set{new_folder(directory), options.settings};
  std::int64_t written = 0;
  for (const GraphClass* kind : kinds) {
    TestClass& made =
        set.classes.emplace_back(TestClass{std::string(kind->name), std::string(kind->family)});
    for (std::int64_t number = 0; number < options.graphs; ++number) {
      made.graphs.push_back(make_graph(options, *kind, number));
      write_graph(set.directory, made.graphs.back());
      if (options.on_graph) options.on_graph(++written);
    }
  }
  set.save();
  return set;
}

}  // namespace pliant
