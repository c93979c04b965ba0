// SPDX-License-Identifier: MIT
#include "pliant/lab/test_sets/read_test_set.hpp"

#include <algorithm>
#include <charconv>

#include "pliant/base/number.hpp"
#include "pliant/base/system/path_text.hpp"
#include "pliant/order/ordering_file.hpp"
#include "pliant/record/xml/xml_document_internal.hpp"
#include "pliant/resolve/techniques.hpp"

namespace pliant {
namespace {

namespace fs = std::filesystem;

/// Reads results.xml and, as it goes, the files that it names.
class Reader {
 public:
  Reader(const SourceText& source, const fs::path& directory) : xml_(source, "test_set") {
    set_.directory = directory;
  }

  TestSet read() {
    const pugi::xml_node root = xml_.root();
    xml_.expect_elements(root, {"class"});
    read_settings(root);
    for (pugi::xml_node node : root.children("class")) read_class(node);
    if (set_.classes.empty()) fail(xml_.place_of(root), "test_set: holds no class");
    return std::move(set_);
  }

 private:
  [[noreturn]] void refuse(pugi::xml_node node, const char* name, std::string_view expected) const {
    fail(xml_.place_of(node), std::string(node.name()) + ": " + name + ": expected " +
                                  std::string(expected) + ", found " +
                                  quoted(xml_.required(node, name)));
  }

  void expect(pugi::xml_node node, const char* name, std::string_view value) const {
    if (xml_.required(node, name) != value) refuse(node, name, quoted(value, 200));
  }

  double real_from(pugi::xml_node node, const char* name, bool zero_too) const {
    const double value = xml_.real(node, name);
    if (value < 0.0 || (value == 0.0 && !zero_too))
      refuse(node, name, zero_too ? "a number from 0" : "a number above 0");
    return value;
  }

  std::uint64_t seed_in(pugi::xml_node node) const {
    const std::string_view text = xml_.required(node, "seed");
    std::uint64_t value = 0;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (code != std::errc{} || end != text.data() + text.size())
      refuse(node, "seed", "a whole number from 0 to 18446744073709551615");
    return value;
  }

  void read_settings(pugi::xml_node node) {
    xml_.expect_attributes(
        node, {"version", "seed", "forces", "force", "timestep", "tolerance_length", "max_sweeps",
               "depth", "children", "ring", "cycles", "joints", "box"});
    expect(node, "version", "1");
    TestSettings& settings = set_.settings;
    settings.seed = seed_in(node);
    settings.forces = xml_.integer(node, "forces", 1);
    settings.force = real_from(node, "force", true);
    settings.timestep = real_from(node, "timestep", false);
    settings.tolerance_length = real_from(node, "tolerance_length", false);
    settings.max_sweeps = xml_.integer(node, "max_sweeps", 1);
    GenerateOptions& sizes = settings.sizes;
    sizes.depth = xml_.integer(node, "depth", 1);
    sizes.children = xml_.integer(node, "children", 1);
    sizes.ring = xml_.integer(node, "ring", 3);
    sizes.cycles = xml_.integer(node, "cycles");
    sizes.joints = xml_.integer(node, "joints");
    sizes.box = real_from(node, "box", false);
  }

  /// The row of a table that an attribute names; an unknown name is an error of the input.
  template <class Find>
  const auto& row_named(pugi::xml_node node, const char* name, Find find) const {
    try {
      return find(xml_.required(node, name));
    } catch (const OptionError& error) {
      fail(xml_.place_of(node), std::string(node.name()) + ": " + name + ": " + error.what());
    }
  }

  void read_class(pugi::xml_node node) {
    xml_.expect_elements(node, {"graph"});
    xml_.expect_attributes(node, {"name", "family"});
    const GraphClass& row = row_named(node, "name", find_graph_class);
    for (const TestClass& earlier : set_.classes)
      if (earlier.name == row.name) refuse(node, "name", "each class once");
    expect(node, "family", row.family);
    TestClass& kind =
        set_.classes.emplace_back(TestClass{std::string(row.name), std::string(row.family)});
    for (pugi::xml_node child : node.children("graph"))
      kind.graphs.push_back(read_graph(child, row, std::int64_t(kind.graphs.size())));
    if (kind.graphs.empty()) fail(xml_.place_of(node), "class " + kind.name + ": holds no graph");
  }

  TestGraph read_graph(pugi::xml_node node, const GraphClass& kind, std::int64_t number) {
    xml_.expect_elements(node, {"force_file", "heuristic"});
    xml_.expect_attributes(node, {"name", "number", "xml", "ordering"});
    expect(node, "number", std::to_string(number));
    const std::string folder = test_set_paths::graph_folder(kind.name, number);
    expect(node, "name", path_text(path_of(folder).filename()));
    expect(node, "xml", folder + "/" + std::string(test_set_paths::graph_file));
    expect(node, "ordering", folder + "/" + std::string(test_set_paths::ordering_file));
    const fs::path inside = set_.directory / folder;
    TestGraph graph{.folder = folder,
                    .number = number,
                    .graph = read_graph_xml(inside / test_set_paths::graph_file)};
    const Framework& framework = graph.graph.framework;
    const std::string fault = class_fault(kind, set_.settings.sizes, framework);
    if (!fault.empty()) fail({path_text(inside / test_set_paths::graph_file)}, fault);
    graph.ordering = read_ordering_file(inside / test_set_paths::ordering_file, framework);
    read_forces(node, graph);
    for (pugi::xml_node child : node.children("heuristic")) read_heuristic(child, graph);
    return graph;
  }

  void read_forces(pugi::xml_node node, TestGraph& graph) const {
    for (pugi::xml_node child : node.children("force_file")) {
      xml_.expect_elements(child, {});
      xml_.expect_attributes(child, {"path", "pushes"});
      const std::string path = test_set_paths::force_file(graph, graph.force_files.size());
      expect(child, "path", path);
      const fs::path file = set_.directory / path;
      graph.force_files.push_back(read_force_file(file, graph.graph.framework));
      check_forces(file, graph.force_files.back(), xml_.integer(child, "pushes", 1));
    }
    const auto pushes = std::int64_t(graph.pushes().size());
    if (pushes != set_.settings.forces)
      fail(xml_.place_of(node), "graph: expected " + std::to_string(set_.settings.forces) +
                                    " pushes in its force files, found " + std::to_string(pushes));
  }

  void check_forces(const fs::path& file, const ForceFile& forces, std::int64_t pushes) const {
    const TestSettings& settings = set_.settings;
    if (!forces.counts.empty()) fail({path_text(file)}, "expected one push a step");
    if (std::int64_t(forces.pushes.size()) != pushes)
      fail({path_text(file)}, "expected " + std::to_string(pushes) + " pushes, as " +
                                  std::string(test_set_paths::index_file) + " has it, found " +
                                  std::to_string(forces.pushes.size()));
    if (forces.timestep != settings.timestep || forces.tolerance ||
        forces.tolerance_length != settings.tolerance_length ||
        forces.max_sweeps != settings.max_sweeps)
      fail({path_text(file)}, "expected the timestep, tolerance_length and max_sweeps of " +
                                  std::string(test_set_paths::index_file) + ", found others");
  }

  void read_heuristic(pugi::xml_node node, TestGraph& graph) const {
    xml_.expect_elements(node, {"results"});
    xml_.expect_attributes(node, {"technique", "weighting", "path"});
    const TechniqueEntry& entry = row_named(node, "technique", find_technique);
    TestHeuristic heuristic{std::string(entry.name), real_from(node, "weighting", true)};
    if (heuristic.weighting > 1.0) refuse(node, "weighting", "a number from 0 to 1");
    expect(node, "path", test_set_paths::heuristic(graph, heuristic));
    for (const TestHeuristic& earlier : graph.heuristics)
      if (earlier.name() == heuristic.name()) refuse(node, "path", "each heuristic once");
    for (pugi::xml_node child : node.children("results")) {
      if (heuristic.results) fail(xml_.place_of(child), "heuristic: holds results twice");
      expect(child, "path",
             test_set_paths::heuristic(graph, heuristic) + "/" +
                 std::string(test_set_paths::table_file));
      heuristic.results = summary_in(child);
    }
    graph.heuristics.push_back(std::move(heuristic));
  }

  TestSummary summary_in(pugi::xml_node node) const {
    xml_.expect_elements(node, {});
    xml_.expect_attributes(node, {"path", "forces", "converged", "mean", "mode", "sd"});
    expect(node, "forces", std::to_string(set_.settings.forces));
    TestSummary summary{set_.settings.forces, xml_.integer(node, "converged"),
                        real_from(node, "mean", true), xml_.integer(node, "mode"),
                        real_from(node, "sd", true)};
    if (summary.converged > summary.forces) refuse(node, "converged", "at most the forces");
    return summary;
  }

  XmlDocument xml_;
  TestSet set_;
};

}  // namespace

TestSet read_test_set(const fs::path& directory) {
  std::error_code error;
  const fs::path folder = fs::weakly_canonical(fs::absolute(directory, error), error);
  const fs::path index = folder / test_set_paths::index_file;
  const std::string bytes = read_bytes(index), name = path_text(index);
  const SourceText source{name, without_byte_order_mark(bytes)};
  return Reader(source, folder).read();
}

}  // namespace pliant
