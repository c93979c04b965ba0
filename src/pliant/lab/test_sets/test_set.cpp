// SPDX-License-Identifier: MIT
#include "pliant/lab/test_sets/test_set.hpp"

#include <algorithm>

#include "pliant/base/choices.hpp"
#include "pliant/base/number.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/record/xml/xml_document_internal.hpp"
#include "pliant/resolve/techniques.hpp"
#include "pliant/text/output_file.hpp"

namespace pliant {
namespace {

namespace fs = std::filesystem;

std::string attribute(std::string_view name, std::string_view value) {
  return " " + std::string(name) + "=\"" + xml_escaped(value) + "\"";
}
std::string attribute(std::string_view name, std::int64_t value) {
  return attribute(name, std::to_string(value));
}
std::string attribute(std::string_view name, double value) {
  return attribute(name, shortest_text(value));
}

std::string settings_text(const TestSettings& settings) {
  const GenerateOptions& sizes = settings.sizes;
  return attribute("version", "1") + attribute("seed", std::to_string(settings.seed)) +
         attribute("forces", settings.forces) + attribute("force", settings.force) +
         attribute("timestep", settings.timestep) +
         attribute("tolerance_length", settings.tolerance_length) +
         attribute("max_sweeps", settings.max_sweeps) + attribute("depth", sizes.depth) +
         attribute("children", sizes.children) + attribute("ring", sizes.ring) +
         attribute("cycles", sizes.cycles) + attribute("joints", sizes.joints) +
         attribute("box", sizes.box);
}

std::string heuristic_text(const TestGraph& graph, const TestHeuristic& heuristic) {
  const std::string folder = test_set_paths::heuristic(graph, heuristic);
  const std::string start = "      <heuristic" + attribute("technique", heuristic.technique) +
                            attribute("weighting", heuristic.weighting) + attribute("path", folder);
  if (!heuristic.results) return start + "/>\n";
  const TestSummary& results = *heuristic.results;
  return start + ">\n        <results" +
         attribute("path", folder + "/" + std::string(test_set_paths::table_file)) +
         attribute("forces", results.forces) + attribute("converged", results.converged) +
         attribute("mean", results.mean) + attribute("mode", results.mode) +
         attribute("sd", results.sd) + "/>\n      </heuristic>\n";
}

std::string graph_text(const TestGraph& graph) {
  const std::string inside = graph.folder + "/";
  std::string text = "    <graph" + attribute("name", path_text(path_of(graph.folder).filename())) +
                     attribute("number", graph.number) +
                     attribute("xml", inside + std::string(test_set_paths::graph_file)) +
                     attribute("ordering", inside + std::string(test_set_paths::ordering_file)) +
                     ">\n";
  for (std::size_t k = 0; k < graph.force_files.size(); ++k)
    text += "      <force_file" + attribute("path", test_set_paths::force_file(graph, k)) +
            attribute("pushes", std::int64_t(graph.force_files[k].pushes.size())) + "/>\n";
  for (const TestHeuristic& heuristic : graph.heuristics) text += heuristic_text(graph, heuristic);
  return text + "    </graph>\n";
}

std::string index_text(const TestSet& set) {
  std::string text =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<test_set" + settings_text(set.settings) + ">\n";
  for (const TestClass& kind : set.classes) {
    text += "  <class" + attribute("name", kind.name) + attribute("family", kind.family) + ">\n";
    for (const TestGraph& graph : kind.graphs) text += graph_text(graph);
    text += "  </class>\n";
  }
  return text + "</test_set>\n";
}

template <class Set>
auto& graph_at(Set& set, const TestPlace& place) {
  const TestClass& kind = set.class_named(place.kind);
  if (place.graph < 0 || place.graph >= std::int64_t(kind.graphs.size()))
    throw OptionError("graph = " + std::to_string(place.graph) + ": class " + kind.name + " has " +
                      std::to_string(kind.graphs.size()) + " graphs, from 0");
  return set.classes[std::size_t(&kind - set.classes.data())].graphs[std::size_t(place.graph)];
}

template <class Row>
auto* find_heuristic(Row& graph, const TestPlace& place) {
  const auto at =
      std::find_if(graph.heuristics.begin(), graph.heuristics.end(), [&](const TestHeuristic& row) {
        return row.technique == place.technique && row.weighting == place.weighting;
      });
  return at == graph.heuristics.end() ? nullptr : &*at;
}

void expect_one_row_a_push(const TestGraph& graph, std::size_t rows) {
  const std::size_t pushes = graph.pushes().size();
  if (rows != pushes)
    throw InputError("results of " + graph.folder + ": expected " + std::to_string(pushes) +
                     " rows, one a push, found " + std::to_string(rows));
}

}  // namespace

namespace test_set_paths {

std::string graph_folder(std::string_view kind, std::int64_t number) {
  std::string digits = std::to_string(number);
  if (digits.size() < 3) digits.insert(0, 3 - digits.size(), '0');
  return std::string(kind) + "/graph-" + digits;
}

std::string force_file(const TestGraph& graph, std::size_t k) {
  return graph.folder + "/heuristics/forces/forces-" + std::to_string(k) + ".txt";
}

std::string heuristic(const TestGraph& graph, const TestHeuristic& row) {
  return graph.folder + "/heuristics/" + row.name();
}

}  // namespace test_set_paths

std::string TestHeuristic::name() const { return technique + "-" + shortest_text(weighting); }

std::vector<JointForce> TestGraph::pushes() const {
  std::vector<JointForce> all;
  for (const ForceFile& file : force_files)
    all.insert(all.end(), file.pushes.begin(), file.pushes.end());
  return all;
}

const TestClass& TestSet::class_named(std::string_view name) const {
  return choose(classes, "class in the test set", name);
}

void TestSet::save() const {
  write_text_file(directory / test_set_paths::index_file, index_text(*this), true);
}

const TestSummary& TestSet::write_results(const TestPlace& place, std::span<const TestRow> rows) {
  TestGraph& graph = graph_at(*this, place);
  check(Technique{std::string(place.technique), place.weighting});
  expect_one_row_a_push(graph, rows.size());
  const TestSummary summary = summary_of(rows);
  const std::string text = write_test_rows(rows);
  TestHeuristic* heuristic = find_heuristic(graph, place);
  if (heuristic == nullptr) {
    graph.heuristics.push_back({std::string(place.technique), place.weighting});
    heuristic = &graph.heuristics.back();
  }
  const fs::path folder = directory / test_set_paths::heuristic(graph, *heuristic);
  make_folder(folder);
  write_text_file(folder / test_set_paths::table_file, text, true);
  return heuristic->results.emplace(summary);
}

std::vector<TestRow> TestSet::read_results(const TestPlace& place) const {
  const TestGraph& graph = graph_at(*this, place);
  const TestHeuristic* heuristic = find_heuristic(graph, place);
  if (heuristic == nullptr || !heuristic->results)
    throw OptionError("no results of " + std::string(place.technique) + " with weighting " +
                      shortest_text(place.weighting) + " on " + graph.folder);
  const fs::path path =
      directory / test_set_paths::heuristic(graph, *heuristic) / test_set_paths::table_file;
  const std::string bytes = read_bytes(path), name = path_text(path);
  std::vector<TestRow> rows = parse_test_rows({name, bytes});
  if (rows.empty() || summary_of(rows) != *heuristic->results)
    fail({name}, "is not the table that " + std::string(test_set_paths::index_file) + " sums up");
  return rows;
}

}  // namespace pliant
