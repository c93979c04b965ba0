// SPDX-License-Identifier: MIT
// pliant lab structgen: random graphs of a class, or a whole test set (the thesis' StructGen).
#include <fmt/format.h>

#include "command.hpp"
#include "messages.hpp"
#include "options/structgen_settings.hpp"
#include "output/json.hpp"
#include "pliant/base/printable.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/framework/graph.hpp"
#include "pliant/record/xml/write_graph_xml.hpp"
#include "pliant/text/output_file.hpp"

namespace pliant::app {
namespace {
void write_one(const StructgenSettings& settings) {
  const GraphClass& kind = find_graph_class(settings.kind);
  RandomKey key;
  key.seed = settings.set.settings.seed;
  key.walker = std::uint64_t(settings.number);
  const GeneratedGraph graph = generate(kind, settings.set.settings.sizes, key);
  write_text_file(path_of(settings.output),
                  write_graph_xml(graph.framework, graph.positions, graph.cycles),
                  settings.overwrite);
  const GraphFacts facts = graph_facts(graph.framework);
  if (settings.json)
    return print_json({{"class", kind.name},
                       {"seed", key.seed},
                       {"number", settings.number},
                       {"output", settings.output},
                       {"joints", facts.joints},
                       {"bars", facts.bars},
                       {"cycles", facts.cycles},
                       {"bridges", facts.bridges}});
  fmt::print("{}: {} joints, {} bars, {} cycles in {}\n", kind.name, facts.joints, facts.bars,
             facts.cycles, settings.output);
}

Json set_as_json(const TestSet& set) {
  std::vector<Json> classes;
  for (const TestClass& kind : set.classes) {
    std::vector<std::string> heuristics;
    for (const TestHeuristic& row : kind.graphs[0].heuristics) heuristics.push_back(row.name());
    classes.push_back(
        {{"name", kind.name}, {"graphs", kind.graphs.size()}, {"heuristics", heuristics}});
  }
  return {{"test_set", path_text(set.directory)},
          {"seed", set.settings.seed},
          {"forces", set.settings.forces},
          {"classes", Json::array(classes)}};
}

void print_set(const TestSet& set) {
  for (const TestClass& kind : set.classes) {
    std::size_t joints = 0;
    for (const TestGraph& graph : kind.graphs) joints += graph.graph.framework.joint_count();
    fmt::print("{:<16}{} graphs of {:.1f} joints on average, {} forces each, {} heuristics\n",
               kind.name, kind.graphs.size(), double(joints) / double(kind.graphs.size()),
               set.settings.forces, kind.graphs[0].heuristics.size());
  }
  fmt::print("index           {}\n",
             printable_name(path_text(set.directory / test_set_paths::index_file)));
}

void write_set(StructgenSettings& settings) {
  const std::size_t classes =
      settings.set.classes.empty() ? graph_classes().size() : settings.set.classes.size();
  ProgressBar progress(std::int64_t(classes) * settings.set.graphs, "graphs", settings.json);
  settings.set.on_graph = [&](std::int64_t done) { progress.show(done); };
  const TestSet set = make_test_set(path_of(settings.directory), settings.set);
  settings.json ? print_json(set_as_json(set)) : print_set(set);
}

}  // namespace

int command_structgen(const Arguments& arguments) {
  CommandLine line(
      "pliant lab structgen",
      "Makes random frameworks (points, called joints, and bars of fixed length between them): a\n"
      "tree, or a graph with 1, 2 or n cycles, made in one of the ways listed below (classes).\n"
      "Writes one graph as XML. With --test-set it writes a folder for each class. This holds a\n"
      "folder for each graph, its forces and its ordering, which in turn holds a folder for the\n"
      "results of each heuristic (technique and weighting); results.xml at the top lists them\n"
      "all. Every graph is checked to belong to its class. The same seed makes the same files.");
  StructgenSettings settings;
  add_structgen_options(line, settings);
  line.set_common({"--number", "--seed", "--joints", "--test-set", "--output"});
  if (const int code = line.parse(arguments); code >= 0) return code;
  complete(line, settings);
  settings.directory.empty() ? write_one(settings) : write_set(settings);
  return exit_ok;
}

}  // namespace pliant::app
